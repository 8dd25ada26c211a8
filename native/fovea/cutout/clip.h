// SPDX-License-Identifier: GPL-3.0-or-later
// The opaque pieces of a triangle.
#pragma once

#include <array>
#include <vector>

#include <fovea/cutout/outlines.h>

namespace fovea::cutout {

/// A triangle of a mesh in texture space. The result depends on vertices only by their order, so that triangles that
/// share a side, and texture coordinates there, agree on where it is cut.
struct TextureTriangle {
    std::array<Point, 3> corner;
    std::array<Index, 3> vertex;
};

/// A corner of a piece: a corner of the triangle, a point on one of its sides, or one of the outlines.
struct PieceCorner {
    enum Kind : std::uint8_t { at_corner, on_side, inside } kind;
    /// Number of the triangle's corner or side (from corner i to i + 1), or of the point of the outlines.
    Index number;
    /// Place on the side: share of the way from its end of the lower vertex to the other one.
    double t = 0.0;
    dvec2 place;  ///< in texture space
};

/// Polygons, wound as the triangle, that together are its opaque part. Holes are joined to the polygon around them by a
/// seam that it runs along twice.
using Pieces = std::vector<std::vector<PieceCorner>>;

struct Clipped {
    enum What { whole, nothing, part } what = whole;
    Pieces pieces;  ///< of a part
};

/// `scratch`: reused between calls.
Clipped clip(const TextureTriangle& triangle, const Outlines& outlines, std::vector<Index>& scratch);

/// Joins a hole, wound the other way round, to the polygon around it; `others` are holes that the seam must not cross.
/// Eberly, "Triangulation by Ear Clipping", 2002.
void join_hole(std::vector<PieceCorner>& around, const std::vector<PieceCorner>& hole, const Pieces& others);

}  // namespace fovea::cutout
