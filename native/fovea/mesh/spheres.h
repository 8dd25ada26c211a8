// SPDX-License-Identifier: GPL-3.0-or-later
// A mesh of spheres: of a point cloud.
#pragma once

#include <fovea/mesh/surface.h>

namespace fovea::mesh {

/// A sphere around each center: an icosahedron whose faces are divided in four as often as `count` spheres leave faces
/// for, 5120 faces for one and 20 for a hundred thousand; of still more, an octahedron each.
int sphere_level(std::size_t count);

/// Spheres whose silhouettes have, in the mean over all views, the area of the true ones. The points of one mesh share
/// its outer boundary and need one entry of the scene. `occludes`: whether they hide what lies behind. Throws
/// std::invalid_argument, naming the object, where arrays do not fit together.
OwnedMesh spheres(const std::string& name, In<vec3> centers, In<float> radii, bool occludes);

}  // namespace fovea::mesh
