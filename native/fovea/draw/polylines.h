// SPDX-License-Identifier: GPL-3.0-or-later
// A frame's lines as polylines: what pens draw of them, visible and hidden, without haloes and overshoot.
#pragma once

#include <fovea/draw/frame.h>
#include <fovea/runs/compaction.h>

namespace fovea::draw {

struct Polylines : CompactRuns {
    Array<Index> pen;
    Array<float> shown;

    static constexpr std::tuple pen_columns{
        Column{"pen", &Polylines::pen, "(R,) uint32 of the style's pens, as Pens numbers them; 0xffffffff: none"},
        Column{"shown", &Polylines::shown, "(R,) float32 in [0, 1] that elision leaves"}};
};

/// Takes a frame's steps up to thin().
Polylines polylines_of(Frame& frame);

/// Per run of `lines`: mean of (samples) values along clipped paths over it; of runs between two samples as there.
Array<float> means_over(const ClippedPaths& clipped, const CompactRuns& lines, In<float> values);

}  // namespace fovea::draw
