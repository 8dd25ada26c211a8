// SPDX-License-Identifier: GPL-3.0-or-later
// What a style says of each path and of each atlas sample along the lines.
#pragma once

#include <fovea/draw/overrides.h>
#include <fovea/focus/focus.h>
#include <fovea/focus/transfer.h>
#include <fovea/path/line_set.h>
#include <fovea/style/style.h>
#include <fovea/visibility/runs.h>

namespace fovea::draw {

/// The line sets of a style, for one scene's placements. Throws std::invalid_argument for lines that are not known.
std::vector<LineSet> line_sets_of(const style::Style& style, const Overrides& overrides);

/// Per path: `of_set` of its line set, in pixels (`scale` of them are a reference pixel).
Array<float> by_path(const Paths& paths, double scale, const std::vector<double>& of_set);

/// Per path: `of_view` where its definition depends on the view, else `other`.
Array<float> by_view(const Paths& paths, double of_view, double other);

/// Per path: pixels of it that lie inside the frame.
Array<double> lengths_in_frame(const Paths& paths, const ClippedPaths& clipped);

/// The function that a style's numbers describe.
Transfer transfer_of(const style::Transfer& transfer);

/// What a style's elision and maps say of the distance that lines want to keep from others.
struct Density {
    In<float> focus, distance;  ///< per sample, may be empty
    In<float> painted, mapped;  ///< per sample in [0, 1], from a quarter as dense to four times; may be empty
};

/// Per atlas sample [px]: half the distance that lines want to keep from others; 0 on pieces without runs.
Array<float> half_width_px(const style::Style& style, const Paths& paths, const ClippedPaths& clipped, const Runs& runs,
                           const Density& density, double scale);

}  // namespace fovea::draw
