// SPDX-License-Identifier: GPL-3.0-or-later
// Partial visibility: where samples are seen in part, the visible pen fades out and the hidden pen fades in.
#pragma once

#include <fovea/stroke/center_line.h>

namespace fovea::stroke {

/// How a run fades at its ends: its share at places along the piece [px of arc], ascending; linear between two of them.
/// Beyond them it stays what it is at an end that fades, and is 1 at one that does not.
struct Fade {
    Array<double> arc;
    Array<float> share;
    bool at_start = false, at_end = false;
    /// The run's ends: beyond those of the run where its share falls to 0 beyond them.
    double start_px = 0.0, end_px = 0.0;
};

/// The fade of a run of a piece by the samples' `visibility` (atlas order, in [0,1]; may be empty: nothing fades): at
/// each end, the samples before and after it that are neither seen nor hidden wholly, as far as one follows the other.
/// `hidden`: the share is that of what is not seen. Ends where the samples on either side are whole stay sharp, so that
/// what filters moved away from the change does not fade.
void find_fade(const ClippedPaths& clipped, In<float> visibility, Index piece, double start_px, double end_px,
               bool hidden, Fade& out);

/// Adds the points at which a line's opacity bends by a fade; before `shape`.
void insert_bends(CenterLine& line, const Fade& fade);

/// Multiplies opacity; after `shape`.
void fade_ends(CenterLine& line, const Fade& fade);

}  // namespace fovea::stroke
