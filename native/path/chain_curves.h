// Pieces of curves chained into polylines.
#pragma once

#include "base/types.h"
#include "line/curves.h"

namespace fovea {

/// Polylines across triangles; points of curve c are rows.begin(c) .. rows.end(c).
struct CurveChains {
    Rows rows;
    // Per curve.
    Array<std::uint8_t> closed;  ///< the last point repeats the first
    Array<std::uint64_t> anchor; ///< no two have the same: their level (high half) and their lowest triangle
    // Per point.
    Array<vec3> point;           ///< object space
    Array<float> strength;
    Array<Index> triangle;       ///< of the piece from this point; the last repeats the one before
    Array<Index> side;           ///< of triangles (mesh/triangle_sides.h) that the point is on; `none`: inside a triangle
};

/// Links pieces that end on the same side of two triangles: by its number, no distances are compared. A side where
/// three or more pieces end (a non-manifold edge) ends them all. The result depends on the order of the pieces alone.
CurveChains chain_curves(const Curves& pieces);

}  // namespace fovea
