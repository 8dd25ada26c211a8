// SPDX-License-Identifier: GPL-3.0-or-later
// Where visible lines cross in the image, and which of two is the farther one.
#pragma once

#include <fovea/visibility/runs.h>

namespace fovea::runs {

/// A visible run passes behind another visible line.
struct PassBehind {
    Index piece;
    double arc_px;  ///< of the piece that passes behind
    double sine;    ///< of the angle between the two lines in the image, over a few pixels
};

/// Every place where a visible run of a path that is `wanted` (one entry per path of Paths) crosses a visible run that
/// is nearer by more than eight pixels' size in space; lines that meet, or lie on the same surface, do not. Runs count
/// as 2 px longer than they are, so that what hides them at their ends is found; there the other must be nearer by
/// more, as a line that turns away on its own surface is soon far behind it. Lines found in the image hide nothing and
/// are not hidden. Ascending by piece; a crossing at a joint of segments may come more than once. Through a uniform
/// grid over the image, in parallel; the same for any number of threads.
Array<PassBehind> passes_behind(const ClippedPaths& clipped, const Runs& runs, In<std::uint8_t> wanted);

}  // namespace fovea::runs
