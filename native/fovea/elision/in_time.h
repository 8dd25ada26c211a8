// SPDX-License-Identifier: GPL-3.0-or-later
// Temporal smoothing of elision: the elision opacity of view-independent lines is averaged over neighboring frames.
#pragma once

#include <fovea/elision/line_places.h>

namespace fovea::elision {

/// Elision opacity of the view-independent lines of one frame.
struct ShownLines {
    LinePlaces places;
    Array<float> shown;  ///< per sample of `places`, in [0, 1]
};

/// `shown`: elision opacity per atlas sample (elision/opacity.h). `width`, `height`: of the picture [px].
ShownLines shown_lines(const ClippedPaths& clipped, const Paths& paths, const Scene& scene, const Runs& runs,
                       In<float> shown, int width, int height);

/// A neighboring frame: its offset in frames (negative: earlier), and its lines.
using FrameNear = std::pair<int, std::shared_ptr<const ShownLines>>;

/// Opacity factor per atlas sample, smoothed over `frames` frames to each side: the mean of the values at the same
/// place of the same line in this frame and those near it, with triangular weights (frames + 1 - |offset|). So lines
/// visible throughout change by at most 1 / (frames + 1) per frame. Other frames are interpolated linearly between
/// samples; frames in which the place is not in the picture, or hidden where it is visible here or vice versa, do not
/// count. Samples on no line of `now`, or outside of the picture, are unchanged, as are all without other frames.
/// Throws std::invalid_argument where an offset is 0 or exceeds `frames`.
Array<float> smoothed_in_time(In<float> shown, const ShownLines& now, In<FrameNear> near, int frames);

/// Sets the opacity of the samples of `places` that are visible over frames, but not now (`now` is 0, per atlas
/// sample): to its mean in those near frames where the place is visible; 1 where it is in none.
void show_as_near(Array<float>& shown, const LinePlaces& places, In<float> now, In<FrameNear> near);

}  // namespace fovea::elision
