// SPDX-License-Identifier: GPL-3.0-or-later
// Normals and areas of vertices.
#pragma once

#include <fovea/field/neighbors.h>

namespace fovea::field {

/// Unit normals, one per vertex: triangle normals weighted so that they are exact on spheres. Zero where a vertex has
/// no triangle with an area. Max, "Weights for Computing Vertex Normals from Facet Normals", JGT 1999.
Array<vec3> vertex_normals(const Surface& surface, const Neighbors& neighbors);

/// Share of each corner of a triangle in its area: Voronoi, cut off at the triangle where it is obtuse. All zero for a
/// triangle without area. Meyer et al., "Discrete Differential-Geometry Operators", VisMath 2002.
dvec3 corner_areas(const dvec3& p0, const dvec3& p1, const dvec3& p2);

/// Area that belongs to each vertex (squared length): the sum of its corners; zero without triangles.
Array<float> vertex_areas(const Surface& surface, const Neighbors& neighbors);

}  // namespace fovea::field
