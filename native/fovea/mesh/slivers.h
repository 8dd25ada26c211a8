// SPDX-License-Identifier: GPL-3.0-or-later
// Triangles of a polygon whose corners lie almost on a line.
#pragma once

#include <fovea/mesh/surface.h>

namespace fovea::mesh {

struct TriangleSize {
    dvec3 area;              ///< twice, along the normal
    double longest_squared;  ///< of its sides
};
TriangleSize size_of(const Array<vec3>& positions, const Triangle& triangle);

/// Writes, for each of the triangles [begin, end) of one polygon, the triangle in whose plane it is taken to lie:
/// itself, unless it is a sliver, no higher than 1 % of its longest side. A corner that is a little off turns a sliver
/// any way, so it goes with a neighbor in the polygon, preferably across a long side, if it lies in the neighbor's
/// plane to 1 % of its length; chains of slivers go with the triangle at their end. Slivers among slivers alone, as in
/// narrow strips, stand for themselves. Independent of the order of the triangles and of their corners. Returns how
/// many lie in their own plane.
Index find_leaders(const Array<vec3>& positions, const Array<Triangle>& triangles, Index begin, Index end,
                   Array<Index>& leader);

}  // namespace fovea::mesh
