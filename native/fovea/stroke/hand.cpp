// SPDX-License-Identifier: GPL-3.0-or-later
#include <fovea/stroke/hand.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace fovea::stroke {
namespace {

constexpr double steps_per_wave = 6.0;
constexpr int pressure_steps = 16;

/// Hash of an integer (splitmix64, Steele et al. 2014).
std::uint64_t mixed(std::uint64_t x) {
    x += 0x9e3779b97f4a7c15u;
    x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9u;
    x = (x ^ (x >> 27)) * 0x94d049bb133111ebu;
    return x ^ (x >> 31);
}

/// Noise in [-1,1] at integers.
double lattice(std::int64_t i, std::uint64_t seed) {
    return double(mixed(seed ^ mixed(std::uint64_t(i))) >> 11) * 0x1p-52 - 1.0;
}

/// Smooth noise in [-1,1]: value noise with a continuous second derivative.
double noise(double x, std::uint64_t seed) {
    const double below = std::floor(x), t = x - below;
    const double s = t * t * t * (t * (6.0 * t - 15.0) + 10.0);
    return glm::mix(lattice(std::int64_t(below), seed), lattice(std::int64_t(below) + 1, seed), s);
}

dvec2 normal_at(const CenterLine& line, std::size_t i) {
    const dvec2 along = line[std::min(i + 1, line.size() - 1)].px - line[i > 0 ? i - 1 : 0].px;
    const double length = glm::length(along);
    return length > 0.0 ? dvec2(-along.y, along.x) / length : dvec2(0.0);
}

/// Arc lengths inside a line at integer multiples of `step`, independent of where the line begins.
std::vector<double> multiples(const CenterLine& line, double step) {
    std::vector<double> arcs;
    for (double k = std::ceil(line.front().arc / step); k * step < line.back().arc; ++k) arcs.push_back(k * step);
    return arcs;
}

}  // namespace

void wobble(CenterLine& line, double amount_px, double length_px, std::uint64_t seed) {
    if (line.size() < 2 || amount_px <= 0.0 || length_px <= 0.0) return;
    insert_points(line, multiples(line, std::max(length_px / steps_per_wave, 1.0)));
    const double start = line.front().arc, end = line.back().arc;
    std::vector<dvec2> shift(line.size());
    for (std::size_t i = 0; i < line.size(); ++i) {
        const double x = line[i].arc / length_px;
        const double way = (2.0 * noise(x, seed) + noise(2.0 * x, ~seed)) / 3.0;
        const double inside = std::clamp(std::min(line[i].arc - start, end - line[i].arc) / length_px, 0.0, 1.0);
        shift[i] = normal_at(line, i) * (amount_px * way * inside);
    }
    for (std::size_t i = 0; i < line.size(); ++i) line[i].px += shift[i];
}

void press(CenterLine& line, float amount) {
    if (line.size() < 2 || amount <= 0.0f) return;
    const double start = line.front().arc, length = line.back().arc - start;
    std::vector<double> arcs;
    for (int k = 1; k < pressure_steps; ++k) arcs.push_back(start + length * k / pressure_steps);
    insert_points(line, arcs);
    for (CenterPoint& p : line) {
        const double swell = std::sqrt(std::max(std::sin(std::numbers::pi * (p.arc - start) / length), 0.0));
        const float width = 2.0f * p.half_width * float(1.0 - amount * (1.0 - swell));
        // Widths below a pixel become a pixel with opacity scaled down (center_line.h).
        p.half_width = std::max(width, 1.0f) / 2.0f;
        p.opacity *= std::min(width, 1.0f);
    }
}

}  // namespace fovea::stroke
