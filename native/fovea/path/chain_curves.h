// SPDX-License-Identifier: GPL-3.0-or-later
// Chaining of curve segments into polylines.
#pragma once

#include <fovea/base/columns.h>
#include <fovea/line/curves.h>

namespace fovea::path {

/// Polylines across triangles; curve c has the points rows.begin(c) .. rows.end(c) - 1.
struct CurveChains {
    Rows rows;
    Array<std::uint8_t> closed, free;
    Array<std::uint64_t> anchor;
    Array<vec3> point;
    Array<float> strength;
    Array<Index> triangle, side, other;

    static constexpr auto curve_columns = each_of(
        Column{"closed", &CurveChains::closed, "the last point repeats the first"},
        Column{"free", &CurveChains::free, "FreeEnds (path/paths.h): ends at which no other line goes on"},
        Column{"anchor", &CurveChains::anchor,
               "the lowest key of its pieces; of those without, level (high half) and lowest triangle, or the lowest "
               "triangles of both surfaces: no two have the same"});
    static constexpr auto point_columns = each_of(
        Column{"point", &CurveChains::point, "object space"}, Column{"strength", &CurveChains::strength, "in [0, 1]"},
        Column{"triangle", &CurveChains::triangle, "of the piece from this point; the last repeats the one before"},
        Column{"side", &CurveChains::side,
               "side of triangles (mesh/triangle_sides.h) that the point is on; `none`: inside a triangle"},
        Column{"other", &CurveChains::other, "the triangle of the second surface, or `none`"});
};

/// Links segments whose ends have the same side number (and level); no positions are compared. A side with three or
/// more ends (a non-manifold edge) ends all of them. The result depends only on the order of the pieces.
CurveChains chain_curves(const Curves& pieces);

}  // namespace fovea::path
