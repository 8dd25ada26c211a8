// SPDX-License-Identifier: GPL-3.0-or-later
// What focus, distance and elision make of a stroke: a way from the pen in focus to the pen out of focus.
#pragma once

#include <fovea/focus/transfer.h>
#include <fovea/stroke/center_line.h>

namespace fovea::stroke {

/// Per atlas sample, each in [0,1]; empty ones count as 0, `shown` as 1.
struct Emphasis {
    /// 0: in focus.
    In<float> focus;
    /// How far from the camera.
    In<float> distance;
    /// What elision leaves of the opacity.
    In<float> shown;
    /// How far focus leads to the pen out of focus (Cole 2009, 5.3.2).
    Transfer color, texture, width, opacity;
    /// How far distance does.
    Transfer distance_width, distance_opacity;
};

/// Where the emphasis along a run bends, and what it is there; linear in between, to a fiftieth.
struct EmphasisAlong {
    Array<double> arc;
    Array<vec4> mix;
    Array<float> shown;
};

/// Throws std::invalid_argument where an array has not one value per sample.
void check_emphasis(const ClippedPaths& clipped, const Emphasis& emphasis);

/// The emphasis of a run of a piece; empty where it is zero all along. What is shown is that of the run's own
/// samples, held at its ends: those beside them are of other runs, or of none.
void find_emphasis(const ClippedPaths& clipped, const Emphasis& emphasis, Index piece, double start_px, double end_px,
                   EmphasisAlong& out);

/// Adds the points at which the emphasis bends, and sets CenterPoint::mix and ::shown everywhere; before `shape`.
void emphasize(CenterLine& line, const EmphasisAlong& emphasis);

}  // namespace fovea::stroke
