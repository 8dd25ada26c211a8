// SPDX-License-Identifier: GPL-3.0-or-later
// A frame's runs that pens draw, visible and hidden, as polylines, without haloes and overshoot.
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

/// Runs a frame's steps up to thin().
Polylines polylines_of(Frame& frame);

/// Per run of `lines`: mean of the per-atlas-sample `values` over it; for a run between two samples, the value there.
Array<float> means_over(const ClippedPaths& clipped, const CompactRuns& lines, In<float> values);

}  // namespace fovea::draw
