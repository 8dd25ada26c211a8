// SPDX-License-Identifier: GPL-3.0-or-later
// From occupancy of bands to the opacity of lines: smoothed along the path, without short remainders.
#pragma once

#include <fovea/elision/own_band.h>

namespace fovea::elision {

struct ElisionOptions {
    /// A line of which no more than this share of its band is left is not drawn; up to a whole band left it fades in.
    float fade_from = 0.35f;
    /// Where a line would be less opaque than this it is left out, for pictures without opacity; 0: nowhere.
    float cut = 0.0f;
    /// What stays of a line between parts that are left out fades away where it is shorter than this; so does the end
    /// of a run next to such a part. A run that is short itself stays.
    double stub_px = 12.0;
};

/// Share of each line's band that is left to it, per sample of a run, in [0,1]: the sums of elision/elide.h over 9
/// samples along the path, over segments and atlas rows, within one run. 1 where there is nothing to see.
Array<float> elision_scores(const OwnBands& own, In<vec2> crowding);

/// Factor for the opacity of lines per atlas sample, in [0,1], 1 where no run is, from scores: 0 at fade_from, 1 at 1,
/// linear between. What is left of shorter than stub_px is taken away by a gray-scale opening along each run (Serra
/// 1982): of all stretches of that length that hold a sample, the one whose faintest sample is the least faint counts.
/// So a small change of scores is a small change of opacities, unless `cut` is set.
Array<float> elision_opacities(const ClippedPaths& clipped, const OwnBands& own, In<float> scores,
                               const ElisionOptions& options);

}  // namespace fovea::elision
