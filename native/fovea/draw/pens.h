// SPDX-License-Identifier: GPL-3.0-or-later
// The pens of a style in pixels of the image, and which of them draws a run: by its line set and by how many surfaces
// hide it.
#pragma once

#include <fovea/draw/assets.h>
#include <fovea/style/style.h>
#include <fovea/visibility/runs.h>

namespace fovea::draw {

/// A pen for the parts of a line set's lines that at least `from` and at most `to` surfaces hide (0: visible parts).
struct PenRange {
    Index line_set, from, to, pen;
};

/// Pens of visible parts by line set, then those of hidden parts, then those out of focus.
struct Pens {
    std::vector<Pen> pens;
    std::vector<PenTexture> textures;  ///< as the pens number them
    std::vector<PenRange> ranges;      ///< which of them draws what
};

/// `scale`: pixels of the image that are a reference pixel. Throws as Assets.
Pens pens_of(const style::Style& style, const Assets& assets, double scale);

/// The same pens as the style has them.
std::vector<style::Pen> pens_in_order(const style::Style& style);

/// The pen of each run: that of the first range which holds it, `none` where no range does. `line_set`: one entry per
/// path of Paths.
Array<Index> pens_of_runs(const ClippedPaths& clipped, const Runs& runs, In<std::uint8_t> line_set,
                          In<PenRange> ranges);

}  // namespace fovea::draw
