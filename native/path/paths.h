// Segments chained into paths.
#pragma once

#include "line/definition.h"

namespace fovea {

/// Ends of a path that touch no other line.
enum FreeEnds : std::uint8_t { free_start = 1, free_end = 2 };

inline constexpr std::uint8_t ends_at_cusps = 2;

/// Polylines in object space, all placements together; points of path p are rows.begin(p) .. rows.end(p). Segment i
/// runs from point i to point i + 1 of its path. A closed path repeats its first point at the end. Paths found in the
/// image belong to no placement: theirs is `none`, they lie in view space, in no place, and nothing hides them.
struct Paths {
    Rows rows;
    // Per path.
    Array<std::uint8_t> closed;
    Array<std::uint64_t> id;       ///< from the object's persistent id and the lowest edge: stable for static lines
    Array<Index> placement;
    Array<std::uint8_t> line_set;  ///< the first line set that wants the path
    Array<std::uint8_t> free_ends; ///< FreeEnds bits
    /// Not 0 where no definition of the surface alone finds it: the path changes with the view. `ends_at_cusps`: its ends
    /// are where it turns away, too.
    Array<std::uint8_t> of_view;
    // Per point.
    Array<vec3> points_obj;
    Array<double> arc_obj;         ///< arc length from the path's start, object units
    Array<Index> place;            ///< where the segment from this point lies: Surface::place (the last: as before)
    Array<float> edge_t;           ///< on an edge, where the point is: 0 at its first vertex, 1 at its second; else 0
    Array<Kinds> kinds;            ///< what the segment from this point is
    Array<float> strength;         ///< in [0,1]
    Array<Index> other_facet;      ///< of a line on two surfaces: the second's facet, numbered over the scene; else
                                   ///< `none`. May be empty: no line lies on two

    Index count() const { return rows.count(); }
    Index other_facet_at(Index point) const { return point < other_facet.size() ? other_facet[point] : none; }
};

}  // namespace fovea
