// SPDX-License-Identifier: GPL-3.0-or-later
// From occupancy of bands to elision opacity of lines: smoothed along the path, short remainders removed.
#pragma once

#include <fovea/elision/own_band.h>

namespace fovea::elision {

struct ElisionOptions {
    /// Score (share of its band left to a line) up to which a line is not drawn; from here to score 1 it fades in.
    float fade_from = 0.35f;
    /// Opacities below this become 0, for output without opacity; 0: off.
    float cut = 0.0f;
    /// Remainders of a line between elided parts fade out if shorter than this; so does the end of a run next to an
    /// elided part. A run that is itself short stays.
    double stub_px = 12.0;
};

/// Score per sample of a run: share in [0,1] of the line's band that is left to it, from the sums of elision/elide.h
/// over 9 samples along the path, across segments and atlas rows, within one run; in a small figure, by the figure's
/// weight, the share that is left to all of it (elision/figures.h). 1 where the window is empty.
Array<float> elision_scores(const OwnBands& own, In<vec2> crowding);

/// Opacity factor per atlas sample from scores, in [0,1], 1 where no run is: 0 at fade_from, 1 at 1, linear between. A
/// small figure fades in proportion to what it loses, and does not vanish, by its weight (elision/figures.h); a dot
/// does. Remainders shorter than stub_px are removed by a gray-scale opening along each run (Serra 1982): each sample
/// gets the greatest, over all windows of that length that contain it, of the windows' least opacities. The result is
/// continuous in the scores, unless `cut` is set.
Array<float> elision_opacities(const ClippedPaths& clipped, const OwnBands& own, In<float> scores,
                               const ElisionOptions& options);

}  // namespace fovea::elision
