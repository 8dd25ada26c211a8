// SPDX-License-Identifier: GPL-3.0-or-later
// Spatial index of straight visible stretches of lines in the image.
#pragma once

#include <algorithm>

#include <fovea/base/types.h>

namespace fovea::runs {

/// The part of a segment of ClippedPaths between two positions in the image [px].
struct Stretch {
    vec2 a, b;
    Index point;  ///< first point of the segment
};

/// A uniform grid over stretches, with about as many cells as stretches.
class StretchGrid {
   public:
    explicit StretchGrid(Array<Stretch>&& stretches);

    /// Calls body(stretch) for every stretch that may cross the one from a to b; some repeatedly, in unspecified order.
    template <typename Body>
    void near(const vec2& a, const vec2& b, const Body& body) const {
        cells(a, b, [&](std::size_t cell) {
            for (Index k = starts_[cell]; k < starts_[cell + 1]; ++k) body(stretches_[entries_[k]]);
        });
    }

   private:
    /// Calls body(cell) for every cell that the segment from a to b touches, within a slack: row by row, the columns
    /// that it spans.
    template <typename Body>
    void cells(const vec2& a, const vec2& b, const Body& body) const {
        constexpr double slack = 1e-3;  // cells
        const dvec2 from = (dvec2(a.y <= b.y ? a : b) - low_) / size_, to = (dvec2(a.y <= b.y ? b : a) - low_) / size_;
        const double slope = to.y > from.y ? (to.x - from.x) / (to.y - from.y) : 0.0;
        const int top = clamped(to.y + slack, height_);
        for (int y = clamped(from.y - slack, height_); y <= top; ++y) {
            double x0 = from.x, x1 = to.x;
            if (slope != 0.0) {
                x0 = from.x + slope * (std::clamp(y - slack, from.y, to.y) - from.y);
                x1 = from.x + slope * (std::clamp(y + 1.0 + slack, from.y, to.y) - from.y);
            }
            const int right = clamped(std::max(x0, x1) + slack, width_);
            for (int x = clamped(std::min(x0, x1) - slack, width_); x <= right; ++x) body(std::size_t(y) * width_ + x);
        }
    }

    static int clamped(double at, int count) { return static_cast<int>(std::clamp(at, 0.0, count - 1.0)); }

    Array<Stretch> stretches_;
    dvec2 low_{0.0};
    double size_ = 1.0;  // of a cell [px]
    int width_ = 1, height_ = 1;
    std::vector<Index> starts_, entries_;  // stretches of each cell
};

}  // namespace fovea::runs
