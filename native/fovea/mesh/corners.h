// SPDX-License-Identifier: GPL-3.0-or-later
// Corners of polygons and triangles at a vertex.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include <fovea/base/elementary.h>
#include <fovea/mesh/surface.h>

namespace fovea::mesh {

/// Vectors from a vertex of a triangle to the next vertex and to the one after that.
inline std::pair<dvec3, dvec3> sides_from(const Surface& surface, Index triangle, Index vertex) {
    const Triangle& t = surface.triangles[triangle];
    const int i = corner_of(t, vertex);
    const dvec3 p(surface.positions[vertex]);
    return {dvec3(surface.positions[t[(i + 1) % 3]]) - p, dvec3(surface.positions[t[(i + 2) % 3]]) - p};
}

/// Angle between those two vectors, in radians.
inline double corner_angle(const Surface& surface, Index triangle, Index vertex) {
    const auto [a, b] = sides_from(surface, triangle, vertex);
    return angle_of(glm::length(glm::cross(a, b)), glm::dot(a, b));
}

/// Mesh corner index of a polygon's vertex; the first one if the vertex occurs more than once.
inline Index corner_at(const Surface& surface, Index polygon, Index vertex) {
    const In<Index> vertices = surface.polygon_vertices(polygon);
    const auto at = std::find(vertices.begin(), vertices.end(), vertex) - vertices.begin();
    return surface.first_corner(polygon) + static_cast<Index>(at);
}

/// Mesh corner indices at the three vertices of a triangle.
inline std::array<Index, 3> triangle_corners(const Surface& surface, Index triangle) {
    const Index polygon = surface.facet_polygon[surface.triangle_facet[triangle]];
    const Triangle& t = surface.triangles[triangle];
    return {corner_at(surface, polygon, t[0]), corner_at(surface, polygon, t[1]), corner_at(surface, polygon, t[2])};
}

}  // namespace fovea::mesh
