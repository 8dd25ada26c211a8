// SPDX-License-Identifier: GPL-3.0-or-later
// Sides of triangles, numbered: the edges that a curve across triangles crosses.
#pragma once

#include <fovea/mesh/surface.h>

namespace fovea::mesh {

/// Every pair of vertices that some triangle joins has one number, whichever triangles share it; diagonals of polygons
/// are among them.
struct TriangleSides {
    Array<glm::uvec3> of_triangle;  ///< per triangle of the surface: side i runs from its vertex i to vertex i + 1
    Array<Edge> vertices;           ///< per side, ascending
};

/// Kept with the surface.
std::shared_ptr<const TriangleSides> triangle_sides(const Surface& surface);

}  // namespace fovea::mesh
