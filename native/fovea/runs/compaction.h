// SPDX-License-Identifier: GPL-3.0-or-later
// Runs as polylines, for strokes, export and `fovea lines --visible`.
#pragma once

#include <fovea/path/paths.h>
#include <fovea/visibility/runs.h>

namespace fovea::runs {

/// Runs as flat arrays in the order of the runs, which is path order. Points of run r are rows.begin(r) .. rows.end(r),
/// two or more; segment i of a run goes from its point i to its point i + 1.
struct CompactRuns {
    Rows rows;
    Array<std::uint64_t> path_id;
    Array<Index> path, piece;
    Array<double> start_px, end_px;
    Array<std::uint8_t> invisibility, line_set, closed;
    Array<vec2> px;
    Array<vec3> position_view;
    Array<double> arc_px;
    Array<float> strength;
    Array<Kinds> kinds;

    static constexpr auto run_columns =
        each_of(Column{"path_id", &CompactRuns::path_id, "(R,) uint64 persistent id of the path"},
                Column{"path", &CompactRuns::path, "(R,) uint32 path of Paths"},
                Column{"piece", &CompactRuns::piece, "(R,) uint32 piece of ClippedPaths"},
                Column{"start_px", &CompactRuns::start_px, "(R,) float64 arc length in pixels, 0 at the path's middle"},
                Column{"end_px", &CompactRuns::end_px, "(R,) float64"},
                Column{"invisibility", &CompactRuns::invisibility, "(R,) uint8 surfaces that hide it; 0: visible"},
                Column{"line_set", &CompactRuns::line_set, "(R,) uint8"},
                Column{"closed", &CompactRuns::closed,
                       "(R,) uint8, 1: all of a closed piece; the last point is the first again"});
    static constexpr auto point_columns = each_of(
        Column{"px", &CompactRuns::px, "(M, 2) float32 pixels, from the lower left corner, y up"},
        Column{"position_view", &CompactRuns::position_view,
               "(M, 3) float32 view space: the eye at 0, looking along -z"},
        Column{"arc_px", &CompactRuns::arc_px, "(M,) float64 arc length in pixels"},
        Column{"strength", &CompactRuns::strength, "(M,) float32 in [0, 1]"},
        Column{"kinds", &CompactRuns::kinds,
               "(M,) uint32 bits of what the segment from the point is, of the last point what that before it is; see "
               "line_definitions()"});
};

/// The points of the paths within each run, and its two ends: pixel positions are interpolated linearly in the image,
/// view-space positions and strength linearly along the line in space. Where a run overshoots its line, the line's end
/// is a point, too, and the run continues in the direction of the line's last 3 pixels, at the depth of its end. Throws
/// std::invalid_argument where runs, pieces and paths do not belong together. Parallel; the result does not depend on
/// the number of threads.
CompactRuns compact(const ClippedPaths& clipped, const Paths& paths, const Runs& runs);

}  // namespace fovea::runs
