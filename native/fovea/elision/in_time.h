// SPDX-License-Identifier: GPL-3.0-or-later
// Elision smoothed in time. Lines of surfaces are at the same places of their meshes in every frame, so what elision
// leaves of them can be a mean over the frames before and after.
#pragma once

#include <fovea/path/paths.h>
#include <fovea/scene/scene.h>
#include <fovea/visibility/runs.h>

namespace fovea::elision {

/// What elision leaves, in one frame, of the lines that no view makes (Paths::of_view). Paths may be longer or shorter
/// in another frame, where a line set before theirs takes edges away from them. So samples are matched across frames by
/// (edge, fraction) on edges of the mesh, each of which is on one path only, and by (path id, fraction of the length in
/// object space) on lines across triangles, which are always whole. Both keys hold under motion and deformation.
struct ShownLines {
    static constexpr float unseen = -1.0f;

    /// An edge of a placement, or a path across triangles; ascending.
    using Key = std::uint64_t;
    /// Where it lies on a path of the frame: from .. to in arc length, object units. By key.
    struct Part {
        Key key;
        Index path;
        double from, to;
    };
    struct Sample {
        Index number;  ///< in the atlas
        Key key;
        double share;  ///< in [0,1], of what the key tells
        double arc;    ///< length from the path's start, object units; ascending along a stretch
        double reach;  ///< how far before and after it the sample speaks for the line, object units
        float shown;   ///< factor for opacity in [0,1]; `unseen` outside of the picture
    };

    Array<Part> parts;
    /// Per stretch, which is a run: its path, ascending, whether surfaces hide it, and its samples.
    Array<Index> path;
    Array<std::uint8_t> hidden;
    Rows rows;
    Array<Sample> samples;
};

/// `shown`: per atlas sample, as of elision/opacity.h. Width and height in pixels, of the picture.
ShownLines shown_lines(const ClippedPaths& clipped, const Paths& paths, const Scene& scene, const Runs& runs,
                       In<float> shown, int width, int height);

/// Another frame: how many frames later it is or, below 0, earlier; and its lines.
using FrameNear = std::pair<int, std::shared_ptr<const ShownLines>>;

/// Factor for the opacity of lines per atlas sample, smoothed over so many frames to each side: the mean of what the
/// frame and those near it show of the same place of the same line, weighted by a triangle (frames + 1 - |away|). So
/// what is seen throughout changes by 1 / (frames + 1) a frame at most. Other frames are interpolated linearly between
/// samples; frames that do not see the place, or see it hidden where it is visible here, or the other way round, do not
/// count. Samples that are on no line of `now`, or outside of the picture, stay as they are, and without other frames
/// all do. Throws std::invalid_argument where a frame is farther away than `frames`, or is the frame itself.
Array<float> smoothed_in_time(In<float> shown, const ShownLines& now, In<FrameNear> near, int frames);

}  // namespace fovea::elision
