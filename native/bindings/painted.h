// SPDX-License-Identifier: GPL-3.0-or-later
// Painted values as Python hands them over.
#pragma once

#include <pybind11/stl.h>

#include <fovea/path/painted.h>

#include "bindings/arrays.h"

namespace fovea::bindings {

/// Per placement (C,) float32, or None.
using PaintedArrays = std::vector<std::optional<Arg<float>>>;

/// Valid as long as `painted`.
inline Painted borrow_painted(const PaintedArrays& painted) {
    Painted in;
    for (const auto& values : painted) in.push_back(borrow<float>(values, "painted"));
    return in;
}

}  // namespace fovea::bindings
