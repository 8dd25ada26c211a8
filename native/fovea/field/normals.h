// SPDX-License-Identifier: GPL-3.0-or-later
// Vertex normals and areas.
#pragma once

#include <fovea/field/neighbors.h>

namespace fovea::field {

/// Unit normal of a vertex: the mean of triangle normals with weights that make it exact on spheres. Zero where the
/// vertex has no triangle with positive area. Max, "Weights for Computing Vertex Normals from Facet Normals", JGT 1999.
vec3 vertex_normal(const Surface& surface, const Neighbors& neighbors, Index vertex);

/// The same, per vertex.
Array<vec3> vertex_normals(const Surface& surface, const Neighbors& neighbors);

/// Area of a triangle divided among its corners: Voronoi areas, clipped to the triangle if it is obtuse. All zero for a
/// triangle without area. Meyer et al., "Discrete Differential-Geometry Operators", VisMath 2002.
dvec3 corner_areas(const dvec3& p0, const dvec3& p1, const dvec3& p2);

/// Area of each vertex (squared object units): sum over its corners; zero without triangles.
Array<float> vertex_areas(const Surface& surface, const Neighbors& neighbors);

}  // namespace fovea::field
