// SPDX-License-Identifier: GPL-3.0-or-later
// Partial visibility: where samples are partly visible, the visible pen fades out and the hidden pen fades in.
#pragma once

#include <fovea/stroke/center_line.h>

namespace fovea::stroke {

/// Opacity factors (`share`) at the ends of a run, at ascending arc lengths of the piece [px], linear between them.
/// Beyond them the factor is constant at an end that fades, and 1 at one that does not.
struct Fade {
    Array<double> arc;
    Array<float> share;
    bool at_start = false, at_end = false;
    /// Ends of the drawn run: beyond the run's own where its factor falls to 0 beyond them.
    double start_px = 0.0, end_px = 0.0;
};

/// The fade of a run of a piece by the samples' `visibility` (atlas order, in [0,1]; may be empty: no fade): at each
/// end, over the consecutive samples before and after it that are only partly visible. `hidden`: the factor is 1 -
/// visibility. Ends between samples that are fully visible or fully hidden stay sharp, so that ends which filters moved
/// away from the visibility change do not fade.
void find_fade(const ClippedPaths& clipped, In<float> visibility, Index piece, double start_px, double end_px,
               bool hidden, Fade& out);

/// Inserts points at the knots of a fade; before `shape`.
void insert_bends(CenterLine& line, const Fade& fade);

/// Multiplies opacity by the fade; after `shape`.
void fade_ends(CenterLine& line, const Fade& fade);

}  // namespace fovea::stroke
