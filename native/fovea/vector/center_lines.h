// SPDX-License-Identifier: GPL-3.0-or-later
// The drawn strokes of a frame as polylines in space, for programs with strokes of their own.
#pragma once

#include <fovea/draw/frame.h>

namespace fovea::vector {

/// Center lines of strokes, as wide, as opaque and of the color that their pens give them; line i has the points
/// rows.begin(i) .. rows.end(i), two or more. A stroke of which nothing is drawn in between is several lines.
struct CenterLines {
    Rows rows;
    Array<std::uint64_t> path_id;
    Array<Index> pen;
    Array<std::uint8_t> line_set, invisibility, closed;
    Array<vec3> position_view, color;
    Array<float> width_px, opacity, strength;
    Array<Kinds> kinds;

    static constexpr auto line_columns =
        each_of(Column{"path_id", &CenterLines::path_id, "(R,) uint64 persistent id of the path, ascending"},
                Column{"pen", &CenterLines::pen, "(R,) uint32 of the style's pens, as Pens numbers them"},
                Column{"line_set", &CenterLines::line_set, "(R,) uint8"},
                Column{"invisibility", &CenterLines::invisibility, "(R,) uint8 surfaces that hide it; 0: visible"},
                Column{"closed", &CenterLines::closed, "(R,) uint8, 1: the last point is the first again"});
    static constexpr auto point_columns = each_of(
        Column{"position_view", &CenterLines::position_view,
               "(M, 3) float32 view space: the eye at 0, looking along -z"},
        Column{"color", &CenterLines::color, "(M, 3) float32 scene-linear"},
        Column{"width_px", &CenterLines::width_px, "(M,) float32 of the whole stroke, in pixels"},
        Column{"opacity", &CenterLines::opacity, "(M,) float32 in [0, 1]; of textures, the mean of their ink"},
        Column{"strength", &CenterLines::strength, "(M,) float32 in [0, 1] of the line"},
        Column{"kinds", &CenterLines::kinds,
               "(M,) uint32 bits of the line definitions of the segment around the point; see line_definitions()"});
};

/// Runs a frame's steps up to shape().
CenterLines center_lines_of(Frame& frame);

}  // namespace fovea::vector
