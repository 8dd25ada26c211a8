// SPDX-License-Identifier: GPL-3.0-or-later
// Spatial index of straight visible stretches of lines in the image.
#pragma once

#include <algorithm>

#include <fovea/base/types.h>

namespace fovea::runs {

/// The part of a segment of ClippedPaths between two positions in the image [px].
struct Stretch {
    vec2 a, b;
    Index point;     ///< first point of the segment
    float distance;  ///< from the eye, of its middle
};

/// A uniform grid over stretches, with about as many cells as stretches, or fewer where these are long. A cell of more
/// than `crowd` stretches has, of those that are alike in it (to 1/16 px), only the one nearest to the eye: so many
/// lines in one place are one line, and cost no more than n log n.
class StretchGrid {
   public:
    static constexpr std::size_t crowd = 512;

    explicit StretchGrid(Array<Stretch>&& stretches);

    /// Number of stretches over all cells.
    std::size_t entries() const { return entries_.size(); }

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

    glm::ivec4 within(const Stretch& stretch, std::size_t cell) const;
    void thin_crowds();

    Array<Stretch> stretches_;
    dvec2 low_{0.0};
    double size_ = 1.0;  // of a cell [px]
    int width_ = 1, height_ = 1;
    std::vector<Index> starts_, entries_;  // stretches of each cell
};

}  // namespace fovea::runs
