// SPDX-License-Identifier: GPL-3.0-or-later
// Settings of a style resolved per path and per atlas sample.
#pragma once

#include <fovea/draw/overrides.h>
#include <fovea/focus/focus.h>
#include <fovea/focus/transfer.h>
#include <fovea/path/line_set.h>
#include <fovea/style/style.h>
#include <fovea/visibility/runs.h>

namespace fovea::draw {

/// The line sets of a style, for one scene's placements, with the files that its definitions are given. Throws
/// std::invalid_argument for unknown line definitions.
std::vector<LineSet> line_sets_of(const style::Style& style, const Overrides& overrides, const Files& files = {});

/// Per path: the value of its line set in `of_set` [reference px], in pixels; `scale`: pixels per reference pixel.
Array<float> by_path(const Paths& paths, double scale, const std::vector<double>& of_set);

/// Per path: the spacing of its line set's pen in focus, in image pixels.
Array<float> spacing_by_path(const Paths& paths, double scale, const style::Style& style);

/// Per run: the width of its line set's pen in focus [px].
Array<float> pen_width_of_runs(const style::Style& style, const Paths& paths, const ClippedPaths& clipped,
                               const Runs& runs, double scale);

/// Paths::of_view, but 0 of lines that make a tone: they do not fold.
Array<std::uint8_t> folding(const Paths& paths);

/// Paths::placement, but `none` of lines that make a tone: others do not go on where they end.
Array<Index> meeting(const Paths& paths);

/// Per path: `of_view` where its definition depends on the view, else `other`.
Array<float> by_view(const Paths& paths, double of_view, double other);

/// Per path: pixels of it that lie inside the frame.
Array<double> lengths_in_frame(const Paths& paths, const ClippedPaths& clipped);

/// 1 - each value: focus from what is painted.
Array<float> inverted(Array<float> values);

/// Inputs that modulate the distance that lines keep from others in elision.
struct Density {
    In<float> focus, distance;  ///< per sample, may be empty
    In<float> painted, mapped;  ///< per sample in [0, 1], a quarter to four times as dense; may be empty
};

/// Per atlas sample [px]: half the distance that lines keep from others; 0 on pieces without runs.
Array<float> half_width_px(const style::Style& style, const Paths& paths, const ClippedPaths& clipped, const Runs& runs,
                           const Density& density, double scale);

}  // namespace fovea::draw
