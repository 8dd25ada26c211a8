// SPDX-License-Identifier: GPL-3.0-or-later
// Curvature averaged over its surroundings.
#pragma once

#include <fovea/field/curvature.h>
#include <fovea/field/neighbors.h>

namespace fovea::field {

/// Both tensors, h and C, averaged over the surroundings of each vertex as a Gaussian in distance weighs them, times
/// area and n . n'; `deviation`: of the Gaussian, in mean edge lengths at the vertex. Tensors are carried from tangent
/// plane to tangent plane, so that spheres and cylinders stay what they are. Does not cross hard edges: vertices on one
/// count for nobody but themselves. Normals stay. As trimesh2 diffuses curvature (Rusinkiewicz).
Array<Curvature> smooth(const Surface& surface, const Neighbors& neighbors, const Array<Curvature>& curvature,
                        double deviation);

}  // namespace fovea::field
