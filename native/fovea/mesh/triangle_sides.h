// SPDX-License-Identifier: GPL-3.0-or-later
// Numbering of the sides of triangles, which curves across triangles cross.
#pragma once

#include <fovea/mesh/surface.h>

namespace fovea::mesh {

/// Every pair of vertices joined by a triangle, including diagonals of polygons, has one number, shared by all
/// triangles at it.
struct TriangleSides {
    Array<glm::uvec3> of_triangle;  ///< per triangle of the surface: side i runs from its vertex i to vertex i + 1
    Array<Edge> vertices;           ///< per side, ascending
};

/// Cached with the surface; that of a stretched surface is its source's.
std::shared_ptr<const TriangleSides> triangle_sides(const Surface& surface);

/// Per side: the triangles at it. Cached with the surface.
std::shared_ptr<const Lists<Index>> triangles_at_sides(const Surface& surface);

}  // namespace fovea::mesh
