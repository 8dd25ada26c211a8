// SPDX-License-Identifier: GPL-3.0-or-later
// A mesh as Python passes it.
#pragma once

#include <vector>

#include <fovea/mesh/surface.h>

#include "bindings/arrays.h"

namespace fovea::bindings {

/// A mesh, and the Python owners of its arrays.
struct Mesh {
    MeshArrays arrays;
    std::vector<py::object> owners;
};

}  // namespace fovea::bindings
