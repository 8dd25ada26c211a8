// SPDX-License-Identifier: GPL-3.0-or-later
// Borders between areas of a picture, each once, so that neighbors have the same one.
#pragma once

#include <algorithm>
#include <functional>
#include <vector>

#include <fovea/vector/curve.h>

namespace fovea::vector {

/// What an area is known by; `nothing`: there is none.
using Label = std::uint64_t;
inline constexpr Label nothing = ~Label(0);

/// The label of a place in pixels. Called by several threads.
using LabelAt = std::function<Label(const dvec2&)>;

/// Labels on a lattice over a picture, beyond whose frame is nothing.
struct Labels {
    int columns = 0, rows = 0;
    int per_px = 1;  ///< points to a pixel along each axis, of which the first is at (0, 0)
    Array<Label> values;

    Label at(int x, int y) const {
        return x < 0 || y < 0 || x >= columns || y >= rows ? nothing : values[std::size_t(y) * columns + x];
    }
    dvec2 place(int x, int y) const {
        return dvec2(std::clamp(x, 0, columns - 1), std::clamp(y, 0, rows - 1)) / double(per_px);
    }
};

Labels labels_of(int width, int height, int per_px, const LabelAt& label_at);

/// The same, where areas of fewer points than `least` have the label of a neighbor.
Labels without_specks(Labels labels, Index least);

/// A line between two labels, in pixels.
struct Border {
    Points points;
    Label left = nothing, right = nothing;  ///< seen along the line
    Index from = none, to = none;  ///< junctions, where more than two labels meet; none: the last point is the first
};

/// All borders, where sides of the lattice find them: features between its points are left out. Along each side the
/// border is found to a thousandth of it.
std::vector<Border> borders_of(const Labels& labels, const LabelAt& label_at);

}  // namespace fovea::vector
