// SPDX-License-Identifier: GPL-3.0-or-later
// The Python module: surfaces, lines and stages as numpy arrays. Independent of Blender.
#include <fovea/base/memory_error.h>

#include "bindings/bind.h"

namespace {

/// MemoryError for what Embree says of memory; pybind11 has it for std::bad_alloc.
void translate_memory_errors(std::exception_ptr thrown) {
    try {
        std::rethrow_exception(thrown);
    } catch (const std::runtime_error& error) {
        if (!fovea::base::is_of_memory(error)) throw;
        PyErr_SetString(PyExc_MemoryError, error.what());
    }
}

}  // namespace

PYBIND11_MODULE(_native, m) {
    using namespace fovea::bindings;
    pybind11::register_local_exception_translator(&translate_memory_errors);
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
    // Notes of Python code about the loaded module. Reimporting resets the module's attributes to those set here, but
    // this dict object stays the same.
    m.attr("notes") = pybind11::dict();
}
