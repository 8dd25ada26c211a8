// SPDX-License-Identifier: GPL-3.0-or-later
// Runs as polylines: what strokes, export and `fovea lines --visible` read back.
#pragma once

#include <fovea/path/paths.h>
#include <fovea/visibility/runs.h>

namespace fovea {

/// Runs as flat arrays in the order of the runs, which is path order. Points of run r are rows.begin(r) .. rows.end(r),
/// two or more; segment i of a run goes from its point i to its point i + 1.
struct CompactRuns {
    Rows rows;
    // Per run.
    Array<std::uint64_t> path_id;  ///< Paths::id
    Array<Index> path, piece;      ///< of Paths, of ClippedPaths
    Array<double> start_px, end_px;
    Array<std::uint8_t> invisibility, line_set;
    Array<std::uint8_t> closed;  ///< 1 where the run is the whole of a closed piece: its last point is its first again
    // Per point.
    Array<vec2> px;
    Array<vec3> position_view;
    Array<double> arc_px;
    Array<float> strength;
    Array<Kinds> kinds;  ///< what the segment from this point is; at the last point: what that before it is
};

/// The points of the paths within each run, and its two ends: interpolated along the image in pixels, along the line in
/// space in positions and strength. Where a run overshoots its line, the line's end is a point of it, too, and it goes
/// on the way that it led over its last 3 pixels, as far from the viewer as that end. Throws std::invalid_argument
/// where runs, pieces and paths do not belong together. Parallel; the same for any number of threads.
CompactRuns compact(const ClippedPaths& clipped, const Paths& paths, const Runs& runs);

}  // namespace fovea
