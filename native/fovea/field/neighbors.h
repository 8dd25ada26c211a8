// SPDX-License-Identifier: GPL-3.0-or-later
// One-rings of vertices, cut at hard edges.
#pragma once

#include <memory>

#include <fovea/mesh/surface.h>

namespace fovea::field {

/// Hard angle with which no edge is hard, not even marked ones and edges of more than two facets.
inline constexpr double no_hard_edges = 1e9;

/// Triangles and vertices around each vertex, ascending. Two vertices are neighbors if a triangle has both (every mesh
/// edge that bounds a surface is a side of a triangle); loose edges and skipped polygons contribute nothing.
///
/// A vertex on a hard edge has only the triangles of one smooth sector, the one of the largest angle at the vertex (of
/// equal ones, that with the lowest triangle index), and their vertices. A traversal from neighbor to neighbor must not
/// continue past such a vertex (`hard`), as it could reach the other side.
struct Neighbors {
    Lists<Index> triangles;    ///< per vertex: indices into the surface's `triangles`
    Lists<Index> vertices;     ///< per vertex
    Array<std::uint8_t> hard;  ///< per vertex: on a hard edge
};

/// Cached with the surface, per hard_angle. An edge is hard if it is marked sharp, has more than two facets, or is a
/// fold: its facets' normals differ by more than `hard_angle` degrees and either by more than 75 degrees or by more
/// than 6 times the mean turn of the surface next to the edge. So bevels of few triangles are not hard. Folds that do
/// not continue at both vertices are treated as noise and dropped. Borders are not hard.
std::shared_ptr<const Neighbors> neighbors_of(const Surface& surface, double hard_angle = default_hard_angle);

}  // namespace fovea::field
