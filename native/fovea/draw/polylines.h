// SPDX-License-Identifier: GPL-3.0-or-later
// A frame's runs that pens draw, visible and hidden, as polylines, without haloes and overshoot.
#pragma once

#include <fovea/draw/frame.h>
#include <fovea/runs/compaction.h>

namespace fovea::draw {

struct Polylines : CompactRuns {
    Array<Index> pen, pen_away;
    Array<float> shown;
    Array<vec4> mix;

    static constexpr std::tuple pen_columns{
        Column{"pen", &Polylines::pen, "(R,) uint32 of the style's pens, as Pens numbers them; 0xffffffff: none"},
        Column{"pen_away", &Polylines::pen_away, "(R,) uint32 the pen out of focus; without one, `pen`"},
        Column{"shown", &Polylines::shown, "(R,) float32 in [0, 1] that elision leaves"}};
    static constexpr std::tuple mix_columns{
        Column{"mix", &Polylines::mix,
               "(M, 4) float32 in [0, 1]: how far color, texture, width and opacity are those of `pen_away`"}};
};

/// Runs a frame's steps up to thin(). Where effects of focus or distance bend along a line, it has points, too.
Polylines polylines_of(Frame& frame);

/// Per run of `lines`: mean of the per-atlas-sample `values` over it; for a run between two samples, the value there.
Array<float> means_over(const ClippedPaths& clipped, const CompactRuns& lines, In<float> values);

}  // namespace fovea::draw
