// SPDX-License-Identifier: GPL-3.0-or-later
#include <fovea/focus/from_surfaces.h>

#include <algorithm>
#include <cmath>

#include <fovea/base/parallel.h>
#include <fovea/focus/each_sample.h>

namespace fovea {
namespace {

constexpr int cell = 4;  // pixels between those of the lattice

/// The samples of a piece, in its order.
struct Along {
    const Focus& focus;
    float reach;
    std::vector<Index> sample;
    std::vector<vec3> place;
    std::vector<float> length;  // along the piece
    Array<float>& f;

    void ask(std::size_t i) { f[sample[i]] = focus(vec2(0.0f), place[i]); }

    /// All between two that are known.
    void between(std::size_t first, std::size_t last) {
        if (last - first < 2) return;
        const float whole = length[last] - length[first];
        if (whole <= reach) {
            for (std::size_t i = first + 1; i < last; ++i) {
                const float share = whole > 0.0f ? (length[i] - length[first]) / whole : 0.0f;
                f[sample[i]] = glm::mix(f[sample[first]], f[sample[last]], share);
            }
            return;
        }
        const std::size_t middle = (first + last) / 2;
        ask(middle);
        between(first, middle);
        between(middle, last);
    }
};

}  // namespace

Array<float> focus_along_pieces(const ClippedPaths& clipped, const Focus& focus) {
    Array<float> f(clipped.samples, 0.0f);
    Array<vec3> places(clipped.samples);
    each_sample(clipped, [&](const SamplePlace& at) { places[at.sample] = position_at(clipped, at); });
    parallel_blocks(clipped.pieces.count(), 16, [&](std::size_t, std::size_t begin, std::size_t end) {
        Along along{focus, focus_tolerance / focus.steepness(), {}, {}, {}, f};
        for (std::size_t q = begin; q < end; ++q) {
            along.sample.clear();
            along.place.clear();
            along.length.clear();
            for (Index i = clipped.pieces.begin(Index(q)); i < clipped.pieces.end(Index(q)); ++i)
                for (Index j = 0; j < clipped.sample_count[i]; ++j) {
                    const Index sample = clipped.sample_start[i] + j;
                    const vec3 here = places[sample];
                    const float step = along.place.empty() ? 0.0f : glm::distance(here, along.place.back());
                    along.length.push_back(along.length.empty() ? 0.0f : along.length.back() + step);
                    along.sample.push_back(sample);
                    along.place.push_back(here);
                }
            if (along.sample.empty()) continue;
            along.ask(0);
            along.ask(along.sample.size() - 1);
            along.between(0, along.sample.size() - 1);
        }
    });
    return f;
}

FocusBetweenPixels::FocusBetweenPixels(const View& view, In<float> distance, const Focus& focus)
    : view_(view),
      distance_(distance),
      focus_(focus),
      clip_to_view_(glm::inverse(view.view_to_clip)),
      reach_(focus_tolerance / focus.steepness()) {}

/// Not finite where the pixel shows nothing.
vec3 FocusBetweenPixels::place(int x, int y) const {
    const float distance = distance_[std::size_t(y) * view_.width + x];
    if (!std::isfinite(distance)) return vec3(distance);
    return vec3(from_pixels(view_, clip_to_view_, dvec2(x + 0.5, y + 0.5), distance));
}

float FocusBetweenPixels::exact(const vec3& place) const { return focus_(vec2(0.0f), place); }

FocusBetweenPixels::Known FocusBetweenPixels::known(int x, int y) const {
    const vec3 there = place(std::min(x, view_.width - 1), std::min(y, view_.height - 1));
    return {there, exact(there)};
}

/// `corners` of the pixel's cell: along x, then along y.
float FocusBetweenPixels::at(int x, int y, const Known corners[4]) const {
    const int u = x % cell, v = y % cell;
    if (u == 0 && v == 0) return corners[0].f;
    const vec3 here = place(x, y);
    for (int i = 0; i < 4; ++i)
        if (!(glm::distance(here, corners[i].place) <= reach_)) return exact(here);
    // At the right and upper border the cell is smaller.
    const auto share = [](int i, int low, int size) { return float(i) / float(std::min(cell, size - 1 - low)); };
    const float s = u == 0 ? 0.0f : share(u, x - u, view_.width), t = v == 0 ? 0.0f : share(v, y - v, view_.height);
    return glm::mix(glm::mix(corners[0].f, corners[1].f, s), glm::mix(corners[2].f, corners[3].f, s), t);
}

Array<float> FocusBetweenPixels::all() const {
    const int columns = (view_.width - 1) / cell + 2, rows = (view_.height - 1) / cell + 2;
    Array<Known> lattice(std::size_t(columns) * rows);
    parallel_blocks(rows, 1, [&](std::size_t, std::size_t first, std::size_t last) {
        for (std::size_t j = first; j < last; ++j)
            for (int i = 0; i < columns; ++i) lattice[j * columns + i] = known(i * cell, int(j) * cell);
    });
    Array<float> f(distance_.size());
    parallel_blocks(view_.height, cell, [&](std::size_t, std::size_t first, std::size_t last) {
        for (std::size_t y = first; y < last; ++y)
            for (int x = 0; x < view_.width; ++x) {
                const Known* low = &lattice[y / cell * columns + x / cell];
                const Known corners[4]{low[0], low[1], low[columns], low[columns + 1]};
                f[y * view_.width + x] = at(x, int(y), corners);
            }
    });
    return f;
}

}  // namespace fovea
