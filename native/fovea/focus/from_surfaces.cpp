// SPDX-License-Identifier: GPL-3.0-or-later
#include <fovea/focus/from_surfaces.h>

#include <algorithm>
#include <cmath>

#include <fovea/base/parallel.h>
#include <fovea/focus/at_samples.h>

namespace fovea::focus {
namespace {

constexpr int cell = 4;  // spacing of the lattice [px]

/// The samples of a piece, in order.
struct Along {
    struct Sample {
        Index number;
        vec3 place;
        float length;  // arc length along the piece, in space
    };
    const Focus& focus;
    float reach;
    Array<float>& f;
    std::vector<Sample> samples;

    void ask(std::size_t i) { f[samples[i].number] = focus(vec2(0.0f), samples[i].place); }

    /// Fills the samples between two that are known.
    void between(std::size_t first, std::size_t last) {
        if (last - first < 2) return;
        const Sample &from = samples[first], &to = samples[last];
        const float whole = to.length - from.length;
        if (whole <= reach) {
            for (std::size_t i = first + 1; i < last; ++i) {
                const float share = whole > 0.0f ? (samples[i].length - from.length) / whole : 0.0f;
                f[samples[i].number] = glm::mix(f[from.number], f[to.number], share);
            }
            return;
        }
        const std::size_t middle = (first + last) / 2;
        ask(middle);
        between(first, middle);
        between(middle, last);
    }
};

class BetweenPixels {
   public:
    BetweenPixels(const View& view, In<float> distance, const Focus& focus)
        : view_(view),
          distance_(distance),
          focus_(focus),
          clip_to_view_(glm::inverse(view.view_to_clip)),
          reach_(focus_tolerance / focus.steepness()) {}

    Array<float> all() const {
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

   private:
    struct Known {
        vec3 place;
        float f;
    };

    /// View-space position seen at a pixel; not finite for background.
    vec3 place(int x, int y) const {
        const float distance = distance_[std::size_t(y) * view_.width + x];
        if (!std::isfinite(distance)) return vec3(distance);
        return vec3(from_pixels(view_, clip_to_view_, dvec2(x + 0.5, y + 0.5), distance));
    }

    float exact(const vec3& place) const { return focus_(vec2(0.0f), place); }

    Known known(int x, int y) const {
        const vec3 there = place(std::min(x, view_.width - 1), std::min(y, view_.height - 1));
        return {there, exact(there)};
    }

    /// f of a pixel. `corners`: of its cell, x running first.
    float at(int x, int y, const Known corners[4]) const {
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

    const View& view_;
    In<float> distance_;
    const Focus& focus_;
    dmat4 clip_to_view_;
    float reach_;  // distance over which f changes by at most the tolerance
};

}  // namespace

Array<float> focus_along_pieces(const ClippedPaths& clipped, const Focus& focus) {
    Array<float> f(clipped.samples, 0.0f);
    const Array<vec3> places = at_samples(clipped, [&](const SamplePlace& at) { return position_at(clipped, at); });
    parallel_blocks(clipped.pieces.count(), 16, [&](std::size_t, std::size_t begin, std::size_t end) {
        Along along{focus, focus_tolerance / focus.steepness(), f, {}};
        for (std::size_t q = begin; q < end; ++q) {
            along.samples.clear();
            for (Index s = clipped.first_sample(Index(q)); s < clipped.first_sample(Index(q + 1)); ++s) {
                const bool first = along.samples.empty();
                const float step = first ? 0.0f : glm::distance(places[s], along.samples.back().place);
                along.samples.push_back({s, places[s], first ? 0.0f : along.samples.back().length + step});
            }
            if (along.samples.empty()) continue;
            along.ask(0);
            along.ask(along.samples.size() - 1);
            along.between(0, along.samples.size() - 1);
        }
    });
    return f;
}

Array<float> focus_between_pixels(const View& view, In<float> distance, const Focus& focus) {
    return BetweenPixels(view, distance, focus).all();
}

}  // namespace fovea::focus
