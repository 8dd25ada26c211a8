// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>

#include <fovea/base/check.h>
#include <fovea/runs/filters.h>

namespace fovea::runs {
namespace {

constexpr double step_px = 2.0;
constexpr double alongside = 0.97;  // cosine of 14 degrees: smaller angles count as parallel, in either direction
/// Times near_px: length over which a line lies beside one that it crosses at that angle.
constexpr double crossing = 3.0;

struct OnRun {
    dvec2 px, way;
};

/// Calls visit(arc, place) along a run every step_px, starting at half a step.
template <typename Visit>
void walk(const ClippedPaths& clipped, const Runs& runs, std::size_t run, const Visit& visit) {
    Index i = clipped.pieces.begin(runs.piece[run]);
    const Index last = clipped.pieces.end(runs.piece[run]) - 1;
    const double length = runs.end_px[run] - runs.start_px[run];
    const auto steps = static_cast<std::int64_t>(std::max(1.0, std::ceil(length / step_px)));
    for (std::int64_t k = 0; k < steps; ++k) {
        const double arc = runs.start_px[run] + (k + 0.5) * length / double(steps);
        while (i + 1 < last && clipped.arc_px[i + 1] <= arc) ++i;
        const dvec2 a(clipped.px[i]), b(clipped.px[i + 1]);
        const double part = clipped.arc_px[i + 1] - clipped.arc_px[i], chord = glm::length(b - a);
        if (!(part > 0.0 && chord > 0.0 && std::isfinite(chord))) continue;
        visit(arc, OnRun{glm::mix(a, b, std::clamp((arc - clipped.arc_px[i]) / part, 0.0, 1.0)), (b - a) / chord});
    }
}

/// Uniform grid over sample places of visible runs.
class VisiblePlaces {
   public:
    VisiblePlaces(const ClippedPaths& clipped, const Runs& runs, double near_px) : cell_(std::max(near_px, step_px)) {
        const auto found = parallel_parts<Array<OnRun>>(
            runs.size(), runs_per_block, [&](Array<OnRun>& places, std::size_t begin, std::size_t end) {
                for (std::size_t r = begin; r < end; ++r)
                    if (runs.invisibility[r] == 0)
                        walk(clipped, runs, r, [&](double, const OnRun& place) { places.push_back(place); });
            });
        dvec2 low(INFINITY), high(-INFINITY);
        for (const auto& block : found)
            for (const OnRun& place : block) {
                low = glm::min(low, place.px);
                high = glm::max(high, place.px);
            }
        if (!(low.x <= high.x)) return;
        low_ = low;
        across_ = std::int64_t((high.x - low.x) / cell_) + 1;
        up_ = std::int64_t((high.y - low.y) / cell_) + 1;
        cells_ = lists_of<OnRun>(std::size_t(across_ * up_), [&](const auto& give) {
            for (const auto& block : found)
                for (const OnRun& place : block) give(cell(place.px), place);
        });
    }

    /// Whether a visible run lies alongside `place` within near_px.
    bool holds(const OnRun& place, double near_px) const {
        const dvec2 at = (place.px - low_) / cell_;
        const auto x = std::int64_t(std::floor(at.x)), y = std::int64_t(std::floor(at.y));
        for (std::int64_t j = std::max<std::int64_t>(y - 1, 0); j <= std::min(y + 1, up_ - 1); ++j)
            for (std::int64_t i = std::max<std::int64_t>(x - 1, 0); i <= std::min(x + 1, across_ - 1); ++i)
                for (const OnRun& other : cells_[Index(j * across_ + i)])
                    if (glm::distance(other.px, place.px) < near_px &&
                        std::abs(glm::dot(other.way, place.way)) > alongside)
                        return true;
        return false;
    }

   private:
    std::size_t cell(dvec2 px) const {
        const dvec2 at = (px - low_) / cell_;
        return std::size_t(std::int64_t(at.y) * across_ + std::int64_t(at.x));
    }

    double cell_;
    dvec2 low_{0.0};
    std::int64_t across_ = 0, up_ = 0;
    Lists<OnRun> cells_;
};

/// Appends the parts of a hidden run that do not lie alongside a visible one.
void keep_rest(const ClippedPaths& clipped, const Runs& runs, std::size_t run, const VisiblePlaces& grid,
               double near_px, Runs& out) {
    const double least = crossing * near_px;
    double kept_from = runs.start_px[run], beside_from = 0.0;
    bool beside = false;
    const auto leave = [&](double until) {
        if (beside && until - beside_from >= least) {
            out.push(runs.piece[run], kept_from, beside_from, runs.invisibility[run]);
            kept_from = until;
        }
        beside = false;
    };
    bool first = true;
    walk(clipped, runs, run, [&](double arc, const OnRun& place) {
        const bool now = grid.holds(place, near_px);
        if (now && !beside) beside_from = first ? runs.start_px[run] : arc - 0.5 * step_px;
        if (!now) leave(arc - 0.5 * step_px);
        beside = now;
        first = false;
    });
    leave(runs.end_px[run]);
    out.push(runs.piece[run], kept_from, runs.end_px[run], runs.invisibility[run]);
}

}  // namespace

Runs without_beside_visible(const ClippedPaths& clipped, const Runs& runs, double near_px) {
    check_runs(clipped, runs);
    check(std::isfinite(near_px) && near_px > 0.0, "near_px: not a number above 0");
    const VisiblePlaces grid(clipped, runs, near_px);
    return runs_by_blocks(runs.size(), runs_per_block, [&](Runs& out, std::size_t begin, std::size_t end) {
        for (std::size_t r = begin; r < end; ++r)
            if (runs.invisibility[r] == 0)
                out.push(runs, r);
            else
                keep_rest(clipped, runs, r, grid, near_px, out);
    });
}

}  // namespace fovea::runs
