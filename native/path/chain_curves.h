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
    /// No two have the same: level (high half) and lowest triangle, or the lowest triangles of both surfaces.
    Array<std::uint64_t> anchor;
    // Per point.
    Array<vec3> point;           ///< object space
    Array<float> strength;
    Array<Index> triangle;       ///< of the piece from this point; the last repeats the one before
    Array<Index> side;           ///< of triangles (mesh/triangle_sides.h) that the point is on; `none`: inside a triangle
    Array<Index> other;          ///< the same of the second surface, or `none`
};

/// Links pieces that end on the same side of two triangles: by its number, no distances are compared. A side where
/// three or more pieces end (a non-manifold edge) ends them all. The result depends on the order of the pieces alone.
CurveChains chain_curves(const Curves& pieces);

}  // namespace fovea
