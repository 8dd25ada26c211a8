// SPDX-License-Identifier: GPL-3.0-or-later
// A frame's runs that pens draw, visible and hidden, as polylines.
#pragma once

#include <fovea/draw/frame.h>
#include <fovea/runs/compaction.h>

namespace fovea::draw {

struct Polylines : CompactRuns {
    Array<Index> pen;
    Array<float> shown;

    static constexpr auto pen_columns = each_of(
        Column{"pen", &Polylines::pen, "(R,) uint32 of the style's pens, as Pens numbers them; 0xffffffff: none"},
        Column{"shown", &Polylines::shown, "(R,) float32 in [0, 1] that elision leaves"});
};

/// Lines before haloes and overshoot; runs a frame's steps up to thin(). `drawn`: as strokes draw them, with these, and
/// with what is seen in frames near by; up to shape().
Polylines polylines_of(Frame& frame, bool drawn = false);

/// Per run of `lines`: mean of the per-atlas-sample `values` over it; for a run between two samples, the value there.
Array<float> means_over(const ClippedPaths& clipped, const CompactRuns& lines, In<float> values);

}  // namespace fovea::draw
