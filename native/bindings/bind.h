// SPDX-License-Identifier: GPL-3.0-or-later
// What module.cpp puts together.
#pragma once

#include <pybind11/pybind11.h>

namespace fovea::bindings {

void bind_base(pybind11::module_& m);
void bind_mesh(pybind11::module_& m);
void bind_field(pybind11::module_& m);
void bind_line(pybind11::module_& m);
void bind_stages(pybind11::module_& m);
void bind_sampled(pybind11::module_& m);
void bind_compaction(pybind11::module_& m);
void bind_filters(pybind11::module_& m);
void bind_focus(pybind11::module_& m);
void bind_elision(pybind11::module_& m);
void bind_in_time(pybind11::module_& m);
void bind_stroke(pybind11::module_& m);
void bind_spine(pybind11::module_& m);
void bind_color(pybind11::module_& m);
void bind_style(pybind11::module_& m);
void bind_draw(pybind11::module_& m);

}  // namespace fovea::bindings
