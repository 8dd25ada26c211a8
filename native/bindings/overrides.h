// SPDX-License-Identifier: GPL-3.0-or-later
// What an artist has said of a scene's placements, as Python hands it over.
#pragma once

#include <fovea/draw/overrides.h>

#include "bindings/arrays.h"

namespace fovea::bindings {

using namespace draw;

/// Overrides that keep alive what they borrow.
struct OwningOverrides {
    Overrides overrides;
    std::vector<py::object> owners;
};

void bind_overrides(py::module_& m);

}  // namespace fovea::bindings
