// SPDX-License-Identifier: GPL-3.0-or-later
// The one-ring of each vertex, cut at hard edges.
#pragma once

#include <memory>

#include <fovea/mesh/surface.h>

namespace fovea::field {

/// As an angle: no edge is hard, marks and edges of many facets included.
inline constexpr double no_hard_edges = 1e9;

/// Triangles and vertices around each vertex, ascending. Vertices are neighbors when a triangle has both (every mesh
/// edge that bounds a surface is a side of a triangle); loose edges and skipped polygons make none.
///
/// A vertex on a hard edge has only the triangles of one smooth sector, the one of the largest angle at the vertex (of
/// equals the one with the lowest triangle), and their vertices. A walk from neighbor to neighbor must not go on from
/// such a vertex (`hard`): what lies beyond may be on the other side.
struct Neighbors {
    Lists<Index> triangles;    ///< per vertex: of the surface's `triangles`
    Lists<Index> vertices;     ///< per vertex
    Array<std::uint8_t> hard;  ///< per vertex: on a hard edge
};

/// Kept with the surface. An edge is hard when it is marked sharp, has more than two facets, or its facets' normals
/// differ by more than `hard_angle` degrees and by far more than the surface turns beside the edge (or by more than 75
/// degrees). A bevel of few triangles is not hard, nor is a single sharp edge that no other continues at either vertex
/// (noise), nor a border.
std::shared_ptr<const Neighbors> neighbors_of(const Surface& surface, double hard_angle = default_hard_angle);

}  // namespace fovea::field
