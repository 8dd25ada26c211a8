// SPDX-License-Identifier: GPL-3.0-or-later
// Line sets that have lines only in light, or only in shade. A line that several of them want is found once, and seen
// once; its parts are then theirs by their shade.
#pragma once

#include <array>
#include <memory>
#include <vector>

#include <fovea/path/line_set.h>
#include <fovea/path/paths.h>
#include <fovea/style/style.h>
#include <fovea/visibility/runs.h>
#include <fovea/visibility/shade.h>

namespace fovea::draw {

/// By Shade: the line set of the style that has a line where that is its shade; `none`: nobody has.
using Owners = std::array<Index, 3>;

/// Line sets to find, as which those of a style that share a definition with equal parameters are one where their
/// filters overlap.
struct SharedSets {
    std::vector<LineSet> sets;
    std::vector<Owners> owners;  ///< per set of these; empty: they are the style's, and no light is asked for
};

/// `sets`: those of the style, in its order. A line is that of the first set, by shade.
SharedSets shared_by_light(const std::vector<LineSet>& sets, const style::Style& style);

/// Lines, and what is drawn of them.
struct LitLines {
    std::shared_ptr<const Paths> paths = {};
    std::shared_ptr<const ClippedPaths> clipped = {};
    Runs runs = {};
    Array<float> samples = {};  ///< per atlas sample, or empty
};

/// Gives the runs of paths to their owners. A path with several is there several times afterwards: copies, with ids of
/// their own, follow all others, as do their pieces and samples. `of_path`: index into `owners`. `gap_px`: see
/// by_shade().
LitLines shared_out(LitLines lines, In<std::uint8_t> of_path, const std::vector<Owners>& owners, const Scene& scene,
                    const View& view, double gap_px, const Cancel& cancel);

}  // namespace fovea::draw
