// SPDX-License-Identifier: GPL-3.0-or-later
#include <fovea/focus/transfer.h>

#include <cmath>

#include <fovea/base/check.h>

namespace fovea::focus {
namespace {

void check_curve(In<vec2> curve) {
    for (std::size_t i = 0; i < curve.size(); ++i) {
        const vec2 p = curve[i];
        check(p.x >= 0.0f && p.x <= 1.0f && p.y >= 0.0f && p.y <= 1.0f,
              "transfer: points of the curve must lie between 0 and 1");
        check(i == 0 || curve[i - 1].x < p.x, "transfer: points of the curve must ascend in x");
    }
}

/// Monotone cubic interpolant of points.
class Curve {
   public:
    explicit Curve(In<vec2> points) : points_(points), slope_(points.size(), 0.0f) {
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
        std::size_t i = 0;
        while (points_[i + 1].x < x) ++i;
        const vec2 p = points_[i], q = points_[i + 1];
        const float h = q.x - p.x, t = (x - p.x) / h, s = 1.0f - t;
        return s * s * (1.0f + 2.0f * t) * p.y + t * t * (3.0f - 2.0f * t) * q.y +
               h * s * t * (s * slope_[i] - t * slope_[i + 1]);
    }

   private:
    In<vec2> points_;
    std::vector<float> slope_;
};

}  // namespace

Transfer::Transfer(float start, float end, float strength, In<vec2> curve)
    : start_(start), end_(end), strength_(strength) {
    check(std::isfinite(start) && std::isfinite(end), "transfer: start and end must be finite");
    check(strength >= 0.0f && strength <= 1.0f, "transfer: the strength must lie between 0 and 1");
    check_curve(curve);
    for (int k = 0; k <= steps; ++k) response_[k] = float(k) / steps;
    if (curve.empty()) return;
    const Curve response(curve);
    for (float& y : response_) y = response(y);
}

}  // namespace fovea::focus
