// SPDX-License-Identifier: GPL-3.0-or-later
// Which lines placements have, as Python says it.
#pragma once

#include <vector>

#include <fovea/path/line_set.h>

#include "bindings/arrays.h"

namespace fovea::bindings {

/// A flat array of numbers.
template <typename T>
std::vector<T> numbers(const py::handle& given) {
    const auto array = py::array_t < T, py::array::c_style | py::array::forcecast > ::ensure(given);
    check(array && array.ndim() == 1, "filters of line sets are flat arrays of numbers");
    return {array.data(), array.data() + array.size()};
}

/// (mask of each placement, masks), or None: all materials.
MaterialFilter material_filter(const py::handle& given);

/// {definition: {parameter: a value per placement}}.
std::vector<OwnLines::Parameter> own_parameters(const py::dict& given);

}  // namespace fovea::bindings
