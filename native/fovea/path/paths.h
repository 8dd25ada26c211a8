// SPDX-License-Identifier: GPL-3.0-or-later
// Paths: chained segments.
#pragma once

#include <fovea/base/columns.h>
#include <fovea/line/definition.h>

namespace fovea::path {

/// Bits: ends of a path that touch no other line.
enum FreeEnds : std::uint8_t { free_start = 1, free_end = 2, any_free = 3 };

/// Values of Paths::of_view beside 0 and 1.
inline constexpr std::uint8_t ends_at_cusps = 2, makes_tone = 3;

/// Polylines of all placements, in object space; path p has the points rows.begin(p) .. rows.end(p) - 1. Segment i runs
/// from point i to point i + 1 of its path. A closed path repeats its first point at the end. Paths found in image
/// space have placement and place `none`, are in view space, and are never occluded.
struct Paths {
    Rows rows;
    Array<std::uint8_t> closed;
    Array<std::uint64_t> id;
    Array<Index> placement;
    Array<std::uint8_t> line_set, free_ends, of_view;
    Array<vec3> points_obj;
    Array<double> arc_obj;
    Array<Index> place;
    Array<float> edge_t;
    Array<Kinds> kinds;
    Array<float> strength;
    Array<Index> other_facet;

    static constexpr auto path_columns = each_of(
        Column{"closed", &Paths::closed, "(P,) uint8; a closed path repeats its first point at the end"},
        Column{"ids", &Paths::id,
               "(P,) uint64, from the object's persistent id and the lowest edge: stable over frames for static lines"},
        Column{"placement", &Paths::placement, "(P,) uint32; 0xffffffff: found in the image, in view space"},
        Column{"line_set", &Paths::line_set, "(P,) uint8, the first line set that wants the path"},
        Column{"free_ends", &Paths::free_ends,
               "(P,) uint8: 1 where the start touches no other line, 2 where the end does not"},
        Column{"of_view", &Paths::of_view,
               "(P,) uint8: nonzero if the path depends on the view; 2: a contour whose ends are cusps; 3: one of many "
               "that make a tone, which do not fold, and at which others do not go on"});
    static constexpr auto point_columns = each_of(
        Column{"points_obj", &Paths::points_obj, "(N, 3) float32"},
        Column{
            "arc_obj", &Paths::arc_obj,
            "(N,) float64 arc length from the path's start, object units; in the surface's rest shape, if it has one"},
        Column{"place", &Paths::place,
               "(N,) uint32 where the segment from this point lies: an edge, or the number of edges + a triangle; the "
               "last: as before"},
        Column{"edge_t", &Paths::edge_t,
               "(N,) float32, where on that edge the point is: 0 at its first vertex, 1 at its second; else 0"},
        Column{"kinds", &Paths::kinds, "(N,) uint32, registry bits of the segment from this point"},
        Column{"strength", &Paths::strength, "(N,) float32 in [0, 1]"},
        Column{"other_facet", &Paths::other_facet,
               "(N,) uint32 of a line on two surfaces: the second's facet over the scene; else 0xffffffff. May be "
               "empty: no line lies on two"});

    Index count() const { return rows.count(); }
    Index other_facet_at(Index point) const { return point < other_facet.size() ? other_facet[point] : none; }
};

}  // namespace fovea::path
