// SPDX-License-Identifier: GPL-3.0-or-later
#include <fovea/elision/figures.h>

#include <algorithm>

#include <fovea/base/check.h>
#include <fovea/base/parallel.h>

namespace fovea::elision {

void mark_figures(const Groups& figures, const Runs& runs, In<Index> ranks, float largest_px, OwnBands& own) {
    constexpr float small_enough = 2.0f, too_large = 2.0f * small_enough;  // sizes, in bands' widths
    check(own.runs.count() == runs.size() && ranks.size() == runs.size() && figures.of_run.size() == runs.size(),
          "figures: bands, ranks or groups of other runs");
    own.figure_of_rank.assign(ranks.empty() ? 1 : std::ranges::max(ranks) + std::size_t(1), -1.0f);
    for (std::size_t r = 0; r < runs.size(); ++r)
        if (figures.of_run[r] != none) own.figure_of_rank[ranks[r]] = float(figures.of_run[r]);
    parallel_for(runs.size(), [&](std::size_t r) {
        const Index figure = figures.of_run[r];
        if (figure == none) return;
        for (Index s = own.runs.begin(Index(r)); s < own.runs.end(Index(r)); ++s) {
            const float width = std::min(2.0f * own.band[s].x, largest_px / too_large), length = own.figure[s].z;
            const float weight =
                1.0f - glm::smoothstep(small_enough * width, too_large * width, figures.size_px[figure]);
            own.figure[s] = vec3(float(figure), weight, glm::mix(length, figures.length_px[figure], weight));
        }
    });
}

void mark_dots(const Groups& figures, In<float> pen_px, OwnBands& own) {
    constexpr float largest = 3.0f;  // in widths of the pen
    check(own.runs.count() == pen_px.size() && figures.of_run.size() == pen_px.size(),
          "figures: bands, pens or groups of other runs");
    own.dot = parallel_map<float>(pen_px.size(), [&](std::size_t r) {
        const Index figure = figures.of_run[r];
        if (figure == none || !(pen_px[r] > 0.0f)) return 0.0f;
        const float dot = 1.0f - glm::smoothstep(pen_px[r], largest * pen_px[r], figures.size_px[figure]);
        for (Index s = own.runs.begin(Index(r)); dot > 0.0f && s < own.runs.end(Index(r)); ++s) {
            own.band[s].x = std::max(own.band[s].x, dot * pen_px[r]);
            vec3& own_figure = own.figure[s];
            own_figure = vec3(float(figure), std::max(own_figure.y, dot), own_figure.z * (1.0f - dot));
        }
        return dot;
    });
}

}  // namespace fovea::elision
