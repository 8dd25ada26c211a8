// SPDX-License-Identifier: GPL-3.0-or-later
// How much a surface turns at its edges.
#pragma once

#include <algorithm>
#include <cmath>

#include <fovea/base/elementary.h>
#include <fovea/mesh/surface.h>

namespace fovea::field {

/// Cosine of the angle between the normals of an edge's two facets, as if they were of one orientation.
inline double cosine_at(const Surface& surface, In<EdgeSide> sides) {
    const dvec3 a(surface.facet_plane[sides[0].facet()]), b(surface.facet_plane[sides[1].facet()]);
    return sides[0].forward() == sides[1].forward() ? -glm::dot(a, b) : glm::dot(a, b);
}

/// Angle, in radians, between the normals of the two facets at an edge, 0 to pi; 0 where there are not two.
inline double turn_at(const Surface& surface, Index edge) {
    const In<EdgeSide> sides = surface.sides(edge);
    return sides.size() == 2 ? arc_cosine(std::clamp(cosine_at(surface, sides), -1.0, 1.0)) : 0.0;
}

/// turn_at, negative where the surface is concave.
inline double signed_turn(const Surface& surface, Index edge) {
    const In<EdgeSide> sides = surface.sides(edge);
    const double turn = turn_at(surface, edge);
    if (sides.size() != 2) return 0.0;
    const Edge& e = surface.edges[edge];
    const dvec3 along = dvec3(surface.positions[e.y]) - dvec3(surface.positions[e.x]);
    const auto normal = [&](EdgeSide side) { return dvec3(surface.facet_plane[side.facet()]); };
    const dvec3 into = glm::cross(normal(sides[0]), sides[0].forward() ? along : -along);
    const double away = glm::dot(normal(sides[1]), into) * (sides[0].forward() == sides[1].forward() ? -1.0 : 1.0);
    return away < 0.0 ? turn : -turn;
}

/// Whether shading is continuous across an edge: marked so, or a diagonal in a polygon.
inline bool is_shaded_smooth(const Surface& surface, Index edge) {
    return edge >= surface.mesh_edges ||
           (surface.edge_marks[edge] & (mesh::mark_smooth | mesh::mark_sharp)) == mesh::mark_smooth;
}

}  // namespace fovea::field
