// SPDX-License-Identifier: GPL-3.0-or-later
// Per atlas sample: its position, and the band that its line reserves in the priority buffer.
#pragma once

#include <fovea/visibility/runs.h>

namespace fovea {

/// Bands are at least a pixel wide, so that no line slips between pixels.
inline constexpr float least_half_width_px = 0.5f;

/// The atlas samples that runs cover, in the order of the atlas, and so of the runs; what the elision test reads, on
/// either backend. A sample belongs to the run that covers most of it.
struct OwnBands {
    /// Samples of each run: entries runs.begin(r) .. runs.end(r) of the arrays; a run shorter than a sample may have
    /// none.
    Rows runs;
    /// Number of the sample in the atlas.
    Array<Index> sample;
    /// Pixel position (x, y) and direction (z, w; unit length).
    Array<vec4> place;
    /// x: half the band's width [px], at least least_half_width_px; y: rank of the run; z, w: pixels back to the run's
    /// start, and ahead to its end.
    Array<vec4> band;
    /// Where the run starts (x, y) and ends (z, w) [px].
    Array<vec4> ends;
    /// How far before its end a line begins to hand over to one that goes on there [px].
    float reach_px = 0.0f;
};

/// `ranks`: per run (elision/rank.h). `half_width_px`: per atlas sample, half the width that a line wants there where
/// it is wholly drawn; where runs cover the sample in part it is that much less. What is not a number, or below 0, is
/// 0. `reach_px`: 1.5 times the window over which elision_scores averages, so that a line that begins where another
/// ends is whole there; above 0.
OwnBands own_bands(const ClippedPaths& clipped, const Runs& runs, In<Index> ranks, In<float> half_width_px,
                   float reach_px);

}  // namespace fovea
