// SPDX-License-Identifier: GPL-3.0-or-later
#include <fovea/stroke/hand.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include <fovea/base/elementary.h>
#include <fovea/stroke/anchor.h>

namespace fovea::stroke {
namespace {

constexpr int pressure_steps = 16;

dvec2 normal_at(const CenterLine& line, std::size_t i) {
    const dvec2 along = line[std::min(i + 1, line.size() - 1)].px - line[i > 0 ? i - 1 : 0].px;
    const double length = glm::length(along);
    return length > 0.0 ? dvec2(-along.y, along.x) / length : dvec2(0.0);
}

}  // namespace

void wobble(CenterLine& line, double amount_px, double length_px, const Hand& hand) {
    if (line.size() < 2 || amount_px <= 0.0 || length_px <= 0.0) return;
    insert_points(line, multiples(line, std::max(length_px / steps_per_wave, 1.0)));
    const double start = line.front().arc, end = line.back().arc;
    std::vector<dvec2> shift(line.size());
    for (std::size_t i = 0; i < line.size(); ++i) {
        const double way = noise_along(line[i], length_px, hand);
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
        const double swell = std::sqrt(std::max(sine(std::numbers::pi * (p.arc - start) / length), 0.0));
        thin(p, float(1.0 - amount * (1.0 - swell)));
    }
}

}  // namespace fovea::stroke
