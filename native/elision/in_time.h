// Elision smoothed in time. Lines of surfaces keep their ids from frame to frame, so a place on one is found again, and
// what elision leaves of it can be a mean over the frames before and after.
#pragma once

#include "atlas/runs.h"
#include "path/paths.h"

namespace fovea {

/// What elision leaves, in one frame, of the lines that are told apart by their ids: not those of the view
/// (Paths::of_view), and none that shares its id with another. Places are shares of the whole path's length in object
/// space, so they stay where they are on what moves or bends.
struct ShownLines {
    static constexpr float unseen = -1.0f;

    /// Per stretch, which is a run's samples: the path's id, ascending, and whether surfaces hide it.
    Array<std::uint64_t> id;
    Array<std::uint8_t> hidden;
    /// Samples of stretch s: samples.begin(s) .. samples.end(s) of the arrays below.
    Rows samples;
    Array<Index> sample;  ///< number in the atlas
    Array<double> place;  ///< in [0,1], ascending along a stretch
    Array<double> reach;  ///< how far before and after its place the sample speaks for the line
    Array<float> shown;   ///< factor for opacity in [0,1]; `unseen` outside of the picture
};

/// `shown`: per atlas sample, as of elision/opacity.h. Width and height in pixels, of the picture.
ShownLines shown_lines(const ClippedPaths& clipped, const Paths& paths, const Runs& runs, In<float> shown, int width,
                       int height);

/// Another frame, so many frames later or, below 0, earlier; its lines are there for as long as this is.
struct FrameNear {
    int away;
    const ShownLines& lines;
};

/// Factor for the opacity of lines per atlas sample, smoothed over so many frames to each side: the mean of what the
/// frame and those near it show of the same place of the same line, weighted by a triangle (frames + 1 - |away|). So
/// what is seen throughout changes by 1 / (frames + 1) a frame at most. Other frames are interpolated linearly between
/// samples; frames that do not see the place, or see it hidden where it is visible here, or the other way round, do not
/// count. Samples that are on no line of `now`, or outside of the picture, stay as they are, and without other frames
/// all do. Throws std::invalid_argument where a frame is farther away than `frames`, or is the frame itself.
Array<float> smoothed_in_time(In<float> shown, const ShownLines& now, In<FrameNear> near, int frames);

}  // namespace fovea
