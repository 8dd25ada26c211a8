// SPDX-License-Identifier: GPL-3.0-or-later
// The Python module: surfaces, lines and stages as numpy arrays. Independent of Blender.
#include "bindings/bind.h"

PYBIND11_MODULE(_native, m) {
    using namespace fovea::bindings;
    m.doc() = "Fovea's core: drawings of scenes, and what they are made of, as numpy arrays.";
    bind_base(m);
    bind_style(m);
    bind_mesh(m);
    bind_cutout(m);
    bind_paths(m);
    bind_scene(m);
    bind_focus(m);
    bind_depth(m);
    bind_elision(m);
    bind_stroke(m);
    bind_color(m);
    bind_draw(m);
    bind_vector(m);
    bind_study(m);
    bind_salience(m);
    bind_courses(m);
    bind_gauges(m);
    bind_learn(m);
    // Notes of Python code about the loaded module. Reimporting resets the module's attributes to those set here, but
    // this dict object stays the same.
    m.attr("notes") = pybind11::dict();
}
