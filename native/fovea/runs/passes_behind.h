// SPDX-License-Identifier: GPL-3.0-or-later
// Crossings of visible lines in the image, where one passes behind the other.
#pragma once

#include <fovea/visibility/runs.h>

namespace fovea::runs {

/// A visible run passes behind another visible line.
struct PassBehind {
    Index piece;
    double arc_px;  ///< of the piece that passes behind
    double sine;    ///< of the angle between the two lines in the image, over a few pixels
};

/// All places where a visible run of a `wanted` path (one entry per path of Paths) crosses a visible run that is nearer
/// by more than eight pixels' size in space; lines that meet, or lie on the same surface, do not count. Runs are
/// extended by 2 px, so that the lines that hide them at their ends are found; there the other must be nearer by more,
/// as a line that turns away on its own surface soon lies far behind it. Image-space lines neither hide others nor are
/// hidden. Ascending by piece; a crossing at a joint of segments may be repeated. Uses a uniform grid over the image;
/// parallel, independent of the number of threads.
Array<PassBehind> passes_behind(const ClippedPaths& clipped, const Runs& runs, In<std::uint8_t> wanted);

}  // namespace fovea::runs
