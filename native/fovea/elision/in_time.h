// SPDX-License-Identifier: GPL-3.0-or-later
// Temporal smoothing of elision. View-independent lines lie at the same places of their meshes in every frame, so their
// elision opacity can be averaged over neighboring frames.
#pragma once

#include <fovea/path/paths.h>
#include <fovea/scene/scene.h>
#include <fovea/visibility/runs.h>

namespace fovea::elision {

/// Elision opacity, in one frame, of view-independent lines (those without Paths::of_view). Paths may be longer or
/// shorter in another frame, where an earlier line set takes edges from them. So samples are matched across frames by
/// (edge, fraction) on edges of the mesh, each of which is on one path only, and by (path id, fraction of the length in
/// object space) on lines across triangles, which are always whole. Both keys hold under motion and deformation.
struct ShownLines {
    static constexpr float unseen = -1.0f;

    /// Id of an edge of a placement, or of a path across triangles.
    using Key = std::uint64_t;
    /// Interval of a path of this frame that a key denotes: from .. to in arc length, object units. Sorted by key.
    struct Part {
        Key key;
        Index path;
        double from, to;
    };
    struct Sample {
        Index number;  ///< atlas index
        Key key;
        double share;  ///< fraction in [0,1] of what the key denotes
        double arc;    ///< length from the path's start, object units; ascending along a stretch
        double reach;  ///< range before and after it in which the sample is valid, object units
        float shown;   ///< opacity factor in [0,1]; `unseen` outside of the picture
    };

    Array<Part> parts;
    /// Per stretch (one per run): its path, ascending; whether it is hidden; its samples.
    Array<Index> path;
    Array<std::uint8_t> hidden;
    Rows rows;
    Array<Sample> samples;
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

}  // namespace fovea::elision
