// SPDX-License-Identifier: GPL-3.0-or-later
// A frame's lines as polylines: what pens draw of them, visible and hidden, without haloes and overshoot.
#pragma once

#include <fovea/draw/frame.h>
#include <fovea/runs/compaction.h>

namespace fovea {

struct Polylines : CompactRuns {
    Array<Index> pen;    ///< per run: of Frame::job.style's pens, as Pens numbers them; `none`: no pen draws it
    Array<float> shown;  ///< per run, in [0, 1]: what elision leaves of it
};

/// Takes a frame's steps up to thin().
Polylines polylines_of(Frame& frame);

/// Per run of `lines`: mean of (samples) values along clipped paths over it; of runs between two samples as there.
Array<float> means_over(const ClippedPaths& clipped, const CompactRuns& lines, In<float> values);

}  // namespace fovea
