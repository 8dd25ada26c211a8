// SPDX-License-Identifier: GPL-3.0-or-later
// Fixed-point triangle rasterization with exact coverage of pixel centers: a center on a common edge of two triangles
// on either side of it is covered by exactly one of them.
#pragma once

#include <algorithm>
#include <cmath>

#include <fovea/base/types.h>

namespace fovea::raster {

/// Half-open rectangle of pixels.
struct PixelBox {
    int x0, y0, x1, y1;
    bool empty() const { return x0 >= x1 || y0 >= y1; }
};

inline PixelBox intersect(const PixelBox& a, const PixelBox& b) {
    return {std::max(a.x0, b.x0), std::max(a.y0, b.y0), std::min(a.x1, b.x1), std::min(a.y1, b.y1)};
}

class FixedTriangle {
   public:
    static constexpr std::int64_t one = 256;    // fixed-point units per pixel
    static constexpr float far_away = 1 << 20;  // px; from here on fixed point overflows, and the triangle is empty

    /// Corners in px, in either winding.
    FixedTriangle(vec2 a, vec2 b, vec2 c) {
        const vec2 px[3] = {a, b, c};
        for (int k = 0; k < 3; ++k) {
            if (!(std::abs(px[k].x) < far_away && std::abs(px[k].y) < far_away)) return;
            x_[k] = std::llrint(px[k].x * float(one));
            y_[k] = std::llrint(px[k].y * float(one));
        }
        area_ = (x_[1] - x_[0]) * (y_[2] - y_[0]) - (y_[1] - y_[0]) * (x_[2] - x_[0]);
        const int sign = area_ < 0 ? -1 : 1;
        for (int k = 0; k < 3; ++k) {
            const int l = (k + 1) % 3;
            const std::int64_t dx = sign * (x_[l] - x_[k]), dy = sign * (y_[l] - y_[k]);
            step_x_[k] = -dy * one;
            step_y_[k] = dx * one;
            at_origin_[k] = dx * (one / 2 - y_[k]) - dy * (one / 2 - x_[k]) - !(dy > 0 || (dy == 0 && dx > 0));
        }
    }

    /// True for zero area, or a corner that is non-finite or too far away; covers nothing.
    bool empty() const { return area_ == 0; }

    /// Pixels whose centers are in the bounding box.
    PixelBox box() const {
        const auto [left, right] = std::minmax({x_[0], x_[1], x_[2]});
        const auto [low, high] = std::minmax({y_[0], y_[1], y_[2]});
        return {first_center(left), first_center(low), first_center(right + 1), first_center(high + 1)};
    }

    /// False only if no pixel of the box is covered.
    bool may_touch(const PixelBox& box) const {
        for (int k = 0; k < 3; ++k) {
            const std::int64_t x = step_x_[k] > 0 ? box.x1 - 1 : box.x0, y = step_y_[k] > 0 ? box.y1 - 1 : box.y0;
            if (at_origin_[k] + step_x_[k] * x + step_y_[k] * y < 0) return false;
        }
        return true;
    }

    /// Narrows [begin, end) to the pixels of row y that the triangle covers.
    void span(int y, int& begin, int& end) const {
        for (int k = 0; k < 3; ++k) {
            const std::int64_t start = at_origin_[k] + step_y_[k] * y, step = step_x_[k];
            if (step > 0) {  // start + step * x >= 0
                if (start + step * begin < 0) begin = int(std::min<std::int64_t>(end, (-start + step - 1) / step));
            } else if (step < 0) {
                if (start + step * (end - 1) < 0) end = int(std::max<std::int64_t>(begin, floor(start, -step) + 1));
            } else if (start < 0) {
                end = begin;
            }
        }
    }

    /// Corner after rounding to fixed point, in px.
    dvec2 corner(int k) const { return dvec2(double(x_[k]), double(y_[k])) / double(one); }

   private:
    static std::int64_t floor(std::int64_t a, std::int64_t b) { return a >= 0 ? a / b : -((-a + b - 1) / b); }
    static int first_center(std::int64_t x) { return int(floor(x + one / 2 - 1, one)); }

    std::int64_t x_[3]{}, y_[3]{};
    std::int64_t area_ = 0;
    // Edge functions at pixel centers; >= 0 inside.
    std::int64_t at_origin_[3]{}, step_x_[3]{}, step_y_[3]{};
};

/// Linear interpolation of values at three corners over their triangle; exact at the rounded corners.
template <int N>
class OverTriangle {
    using Value = glm::vec<N, double>;

   public:
    OverTriangle(const FixedTriangle& shape, const Value& a, const Value& b, const Value& c)
        : origin_(shape.corner(0)), at_origin_(a) {
        const dvec2 e = shape.corner(1) - origin_, f = shape.corner(2) - origin_;
        const double area = cross(e, f);
        slope_x_ = ((b - a) * f.y - (c - a) * e.y) / area;
        slope_y_ = ((c - a) * e.x - (b - a) * f.x) / area;
    }

    /// Value at the center of pixel (x, y).
    glm::vec<N, float> at(int x, int y) const {
        return glm::vec<N, float>(at_origin_ + slope_y_ * (y + 0.5 - origin_.y) + slope_x_ * (x + 0.5 - origin_.x));
    }

   private:
    dvec2 origin_;
    Value at_origin_, slope_x_, slope_y_;
};

}  // namespace fovea::raster
