// SPDX-License-Identifier: GPL-3.0-or-later
// Corners of a mesh, by where they are on its surface.
#pragma once

#include <algorithm>
#include <array>

#include <fovea/mesh/surface.h>

namespace fovea {

/// The mesh's corner at a vertex of a polygon (the first, where it comes to it twice).
inline Index corner_at(const Surface& surface, Index polygon, Index vertex) {
    const In<Index> vertices = surface.polygon_vertices(polygon);
    const auto at = std::find(vertices.begin(), vertices.end(), vertex) - vertices.begin();
    return surface.first_corner(polygon) + static_cast<Index>(at);
}

/// Those at the vertices of a triangle.
inline std::array<Index, 3> triangle_corners(const Surface& surface, Index triangle) {
    const Index polygon = surface.facet_polygon[surface.triangle_facet[triangle]];
    const Triangle& t = surface.triangles[triangle];
    return {corner_at(surface, polygon, t[0]), corner_at(surface, polygon, t[1]), corner_at(surface, polygon, t[2])};
}

}  // namespace fovea
