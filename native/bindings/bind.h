// SPDX-License-Identifier: GPL-3.0-or-later
// Functions that module.cpp calls to bind the module, in this order: signatures refer to types bound earlier.
#pragma once

#include <pybind11/pybind11.h>

#include <fovea/mesh/surface.h>

namespace fovea::bindings {

using namespace draw;

using SurfaceClass = pybind11::class_<Surface, std::shared_ptr<Surface>>;

void bind_base(pybind11::module_& m);
void bind_mesh(pybind11::module_& m);
void bind_fields(pybind11::module_& m, SurfaceClass& surface);
void bind_cutout(pybind11::module_& m);
void bind_paths(pybind11::module_& m);
void bind_scene(pybind11::module_& m);
void bind_focus(pybind11::module_& m);
void bind_depth(pybind11::module_& m);
void bind_elision(pybind11::module_& m);
void bind_stroke(pybind11::module_& m);
void bind_color(pybind11::module_& m);
void bind_style(pybind11::module_& m);
void bind_draw(pybind11::module_& m);
void bind_vector(pybind11::module_& m);
void bind_study(pybind11::module_& m);
void bind_salience(pybind11::module_& m);
void bind_courses(pybind11::module_& m);
void bind_gauges(pybind11::module_& m);
void bind_learn(pybind11::module_& m);

}  // namespace fovea::bindings
