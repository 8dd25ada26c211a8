// SPDX-License-Identifier: GPL-3.0-or-later
// What a frame has found of its lines, without its scene: for frames near it, and for itself when its turn comes.
#pragma once

#include <memory>
#include <string>
#include <utility>
#include <vector>

#include <fovea/elision/in_time.h>
#include <fovea/elision/seen_in_time.h>
#include <fovea/path/paths.h>
#include <fovea/project/clipped_paths.h>
#include <fovea/stroke/marks.h>
#include <fovea/visibility/runs.h>

namespace fovea::draw {

/// Lines of a frame as frames near it need them.
struct NearLines {
    std::shared_ptr<const ShownLines> shown;    ///< for elision over frames; null: nothing is elided
    std::shared_ptr<const SeenLines> seen;      ///< for visibility over frames; null: it is not
    std::shared_ptr<const MarkedLines> marked;  ///< for marks over frames; null: they are not handed on
};

/// A neighboring frame: its offset in frames (negative: earlier), and its lines.
using LinesNear = std::pair<int, NearLines>;

/// Members of a Frame after filter(), see there.
struct FoundLines {
    std::shared_ptr<const Paths> paths;
    std::shared_ptr<const ClippedPaths> clipped;
    std::shared_ptr<const Runs> visible, runs;
    Array<float> samples, focus, distance;
    Array<float> shown;  ///< elision opacity per atlas sample, in [0, 1], without neighboring frames; may be empty
    NearLines lines;
    std::vector<std::pair<std::string, double>> stages;

    std::size_t bytes() const;  ///< about
};

}  // namespace fovea::draw
