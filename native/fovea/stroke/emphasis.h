// SPDX-License-Identifier: GPL-3.0-or-later
// Emphasis of a stroke: effects of focus, distance, elision and visibility over frames, as mixes from the pen in focus
// to the one out of focus, and as shares of what is left.
#pragma once

#include <fovea/focus/transfer.h>
#include <fovea/stroke/center_line.h>

namespace fovea::stroke {

/// Per atlas sample, each in [0,1]; empty ones count as 0, `shown` and `seen` as 1.
struct Emphasis {
    /// 0: in focus.
    In<float> focus;
    /// Normalized distance from the camera.
    In<float> distance;
    /// Elision opacity.
    In<float> shown;
    /// Share of the time for which it is seen (elision/seen_in_time.h).
    In<float> seen;
    /// From focus to the mix towards the out-of-focus pen (Cole 2009, 5.3.2).
    Transfer color, texture, width, opacity;
    /// The same from distance.
    Transfer distance_width, distance_opacity;
};

/// Emphasis along a run, piecewise linear to within 1/50: arc lengths of its knots, and its values there.
struct EmphasisAlong {
    Array<double> arc;
    Array<vec4> mix;
    Array<float> shown, seen;
};

/// Throws std::invalid_argument where an array has not one value per sample.
void check_emphasis(const ClippedPaths& clipped, const Emphasis& emphasis);

/// The emphasis of a run of a piece; empty if it is zero all along. What is shown and seen is taken from the run's own
/// samples only and constant beyond them: neighboring samples belong to other runs or to none.
void find_emphasis(const ClippedPaths& clipped, const Emphasis& emphasis, Index piece, double start_px, double end_px,
                   EmphasisAlong& out);

/// Inserts points at the knots of the emphasis, and sets CenterPoint::mix, ::shown and ::seen of all points; before
/// `shape`.
void emphasize(CenterLine& line, const EmphasisAlong& emphasis);

}  // namespace fovea::stroke
