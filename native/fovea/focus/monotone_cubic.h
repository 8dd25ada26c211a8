// SPDX-License-Identifier: GPL-3.0-or-later
// Interpolation of the points of a response curve.
#pragma once

#include <algorithm>
#include <vector>

#include <fovea/base/types.h>

namespace fovea::focus {

/// Monotone cubic through points (Fritsch & Carlson 1980), constant beyond the first and the last; between two points
/// it does not leave the range of their values. The points, at least one and with ascending x, are borrowed.
class MonotoneCubic {
   public:
    explicit MonotoneCubic(In<vec2> points) : points_(points), slope_(points.size(), 0.0f) {
        const auto chord = [&](std::size_t i) {
            return (points[i + 1].y - points[i].y) / (points[i + 1].x - points[i].x);
        };
        const std::size_t last = points.size() - 1;
        for (std::size_t i = 0; i <= last && last > 0; ++i) {
            const float a = chord(i > 0 ? i - 1 : 0), b = chord(i < last ? i : last - 1);
            // The harmonic mean is at most twice the lesser slope, so that the cubic is monotone.
            slope_[i] = a * b > 0.0f ? 2.0f * a * b / (a + b) : 0.0f;
        }
    }

    float operator()(float x) const {
        if (x <= points_.front().x) return points_.front().y;
        if (x >= points_.back().x) return points_.back().y;
        const auto above = std::ranges::lower_bound(points_.begin() + 1, points_.end(), x, {}, &vec2::x);
        const std::size_t i = std::size_t(above - points_.begin()) - 1;
        const vec2 p = points_[i], q = points_[i + 1];
        const float h = q.x - p.x, t = (x - p.x) / h, s = 1.0f - t;
        return s * s * (1.0f + 2.0f * t) * p.y + t * t * (3.0f - 2.0f * t) * q.y +
               h * s * t * (s * slope_[i] - t * slope_[i + 1]);
    }

   private:
    In<vec2> points_;
    std::vector<float> slope_;
};

}  // namespace fovea::focus
