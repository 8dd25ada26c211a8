// SPDX-License-Identifier: GPL-3.0-or-later
// Per-placement overrides from Python.
#pragma once

#include <fovea/draw/overrides.h>

#include "bindings/arrays.h"

namespace fovea::bindings {

/// Overrides with the Python objects whose memory they borrow.
struct OwningOverrides {
    Overrides overrides;
    std::vector<py::object> owners;
};

void bind_overrides(py::module_& m);

}  // namespace fovea::bindings
