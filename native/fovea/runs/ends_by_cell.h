// SPDX-License-Identifier: GPL-3.0-or-later
// Ends of visible runs in a grid over the image, to find those near each other.
#pragma once

#include <tuple>

#include <fovea/visibility/runs.h>

namespace fovea::runs {

/// An end of a run: its cell in a grid, its path and the path's placement, its place, and its outward direction (NaN
/// for a run without length).
struct End {
    std::int64_t row, column;
    Index placement, path;
    dvec2 px, way;

    auto cell() const { return std::tuple(row, placement, column); }
};

/// The end, or the start, of a run; cells are `cell_px` wide. `placement`: per path.
End end_of(const ClippedPaths& clipped, const Runs& runs, In<Index> placement, double cell_px, Index run, bool at_end);

/// Both ends of all visible runs, ascending by cell. Of ends at one place with one direction there are two, of
/// different paths, as whoever looks for others is on one path only. In a cell of more than 256 ends of a placement,
/// those count as one place that are nearly so (to half a pixel and 7 degrees).
Array<End> ends_by_cell(const ClippedPaths& clipped, const Runs& runs, In<Index> placement, double cell_px);

}  // namespace fovea::runs
