// SPDX-License-Identifier: GPL-3.0-or-later
// The pens of a style in image pixels, and the choice of a run's pen by its line set and quantitative invisibility.
#pragma once

#include <fovea/draw/assets.h>
#include <fovea/style/style.h>
#include <fovea/visibility/runs.h>

namespace fovea::draw {

/// The pen of the parts of a line set's lines with quantitative invisibility in [from, to] (0: visible parts).
struct PenRange {
    Index line_set, from, to, pen;
};

/// Pens of visible parts by line set, then those of hidden parts, then those out of focus.
struct Pens {
    std::vector<Pen> pens;
    std::vector<PenTexture> textures;  ///< indexed by Pen::texture
    std::vector<PenRange> ranges;      ///< which pen draws what
};

/// `scale`: image pixels per reference pixel. Throws as Assets.
Pens pens_of(const style::Style& style, const Assets& assets, double scale);

/// The style's pens, in the same order.
std::vector<style::Pen> pens_in_order(const style::Style& style);

/// The pen of each run: that of the first range that contains it, `none` if none does. `line_set`: one entry per path
/// of Paths.
Array<Index> pens_of_runs(const ClippedPaths& clipped, const Runs& runs, In<std::uint8_t> line_set,
                          In<PenRange> ranges);

}  // namespace fovea::draw
