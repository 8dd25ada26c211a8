// SPDX-License-Identifier: GPL-3.0-or-later
#include <fovea/color/screentone.h>

#include <algorithm>
#include <cmath>

#include <fovea/base/check.h>
#include <fovea/base/elementary.h>
#include <fovea/base/parallel.h>
#include <fovea/color/srgb.h>
#include <fovea/style/ranges.h>

namespace fovea::color {
namespace {

constexpr double pi = 3.14159265358979323846;
constexpr int side = 64;  // samples along a cell of the screen

double luminance(const vec3& color) { return 0.2126 * color.r + 0.7152 * color.g + 0.0722 * color.b; }

/// As displayed.
double lightness(double luminance) { return to_srgb(float(std::clamp(luminance, 0.0, 1.0))); }

/// From the middle of a black dot, 1, to that of a white one, -1; its unit is a cell.
double spot(double u, double v) { return 0.5 * (cosine(2.0 * pi * u) + cosine(2.0 * pi * v)); }

/// Values of the spot function over a cell, ascending: of a share of them the last ones are black.
std::vector<double> spots() {
    std::vector<double> values;
    for (int y = 0; y < side; ++y)
        for (int x = 0; x < side; ++x) values.push_back(spot((x + 0.5) / side, (y + 0.5) / side));
    std::ranges::sort(values);
    return values;
}

}  // namespace

int page_height(const Screen& screen, double height_mm) {
    return std::max(1, int(std::lround(height_mm / 25.4 * screen.dpi)));
}

Array<std::uint8_t> screentone(In<vec4> lines, In<vec4> ground, const dvec3& paper, int width, const Screen& screen) {
    style::check_ranges(screen, "screen: ");
    check(lines.size() == ground.size() && width > 0, "screen: lines and ground of one size expected");
    const double cell = screen.dpi / screen.lines_per_inch;
    check(cell >= 2.0, "screen: its dots are smaller than two pixels: lower lines_per_inch, or make dpi higher");
    const std::vector<double> values = spots();
    const double c = cosine(screen.angle * pi / 180.0) / cell, s = sine(screen.angle * pi / 180.0) / cell;
    const double white = std::max(lightness(luminance(vec3(paper))), 1e-3);
    Array<std::uint8_t> bits(lines.size());
    parallel_for(bits.size(), [&](std::size_t i) {
        const vec4& line = lines[i];
        if (line.a > 0.0f && line.a >= float(screen.threshold)) {
            bits[i] = lightness(luminance(vec3(line) / line.a)) > 0.5;
            return;
        }
        const double light = lightness(luminance(vec3(ground[i])) + 1.0 - std::clamp(ground[i].a, 0.0f, 1.0f));
        const auto left_white = std::size_t(std::min(light / white, 1.0) * double(values.size()) + 0.5);
        if (left_white == 0 || left_white >= values.size()) {
            bits[i] = left_white != 0;
            return;
        }
        const double x = double(i % std::size_t(width)) + 0.5, y = double(i / std::size_t(width)) + 0.5;
        bits[i] = spot(c * x + s * y, c * y - s * x) < values[left_white];
    });
    return bits;
}

}  // namespace fovea::color
