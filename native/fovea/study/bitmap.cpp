// SPDX-License-Identifier: GPL-3.0-or-later
#include <fovea/study/bitmap.h>

#include <algorithm>
#include <cmath>

#include <fovea/base/check.h>

namespace fovea::study {
namespace {

/// Calls visit(pixel number, index of the segment's first point, share of the way to the next) along all lines.
template <typename Visit>
void for_each_step(In<vec2> px, In<std::int64_t> offsets, int width, int height, const Visit& visit) {
    check(width > 0 && height > 0, "a drawing needs pixels");
    check(!offsets.empty() && offsets.front() == 0 && offsets.back() == std::int64_t(px.size()) &&
              std::ranges::is_sorted(offsets),
          "offsets: they do not fit the points");
    const double far = 4.0 * (width + height);
    const auto near = [&](const dvec2& p) { return std::abs(p.x) < far && std::abs(p.y) < far; };
    for (std::size_t line = 0; line + 1 < offsets.size(); ++line)
        for (auto i = std::size_t(offsets[line]); i + 1 < std::size_t(offsets[line + 1]); ++i) {
            const dvec2 a(px[i]), b(px[i + 1]);
            if (!near(a) || !near(b)) continue;  // not finite, or far outside
            const int steps = std::max(1, int(std::ceil(2.0 * glm::distance(a, b))));
            for (int k = 0; k <= steps; ++k) {
                const double t = double(k) / steps;
                const dvec2 at = glm::floor(a + t * (b - a));
                if (at.x < 0.0 || at.y < 0.0 || at.x >= width || at.y >= height) continue;
                visit(std::size_t(at.y) * std::size_t(width) + std::size_t(at.x), i, t);
            }
        }
}

}  // namespace

std::size_t Bitmap::count() const { return std::size_t(std::ranges::count(set, 1)); }

double Bitmap::diagonal() const { return std::hypot(width, height); }

void Bitmap::check_size_of(const Bitmap& other) const {
    const auto size = [](const Bitmap& of) { return std::to_string(of.width) + " x " + std::to_string(of.height); };
    check(other.width == width && other.height == height,
          "drawings of " + size(*this) + " and of " + size(other) + " pixels: only drawings of one size are compared");
}

Bitmap pixels_of(In<vec2> px, In<std::int64_t> offsets, int width, int height) {
    Bitmap bitmap(width, height);
    for_each_step(px, offsets, width, height, [&](std::size_t pixel, std::size_t, double) { bitmap.set[pixel] = 1; });
    return bitmap;
}

Array<float> most_at_pixels(In<vec2> px, In<std::int64_t> offsets, In<float> values, int width, int height) {
    check(values.size() == px.size(), "values: one per point expected");
    Array<float> most(std::size_t(width) * std::size_t(height), -1.0f);
    for_each_step(px, offsets, width, height, [&](std::size_t pixel, std::size_t i, double t) {
        most[pixel] = std::max(most[pixel], std::lerp(values[i], values[i + 1], float(t)));
    });
    return most;
}

}  // namespace fovea::study
