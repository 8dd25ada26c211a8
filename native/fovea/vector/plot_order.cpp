// SPDX-License-Identifier: GPL-3.0-or-later
#include <fovea/vector/plot_order.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include <fovea/base/cancel.h>
#include <fovea/base/point_grid.h>

namespace fovea::vector {
namespace {

constexpr double points_per_cell = 2.0;
constexpr int most_passes = 30;
constexpr std::ptrdiff_t widest = 1000;   // strokes over which a part of the way is turned around
constexpr std::ptrdiff_t narrowest = 10;  // and where there are many, so that trials are enough for some rounds
constexpr std::size_t shared = 20;        // trials of a stroke in these rounds, in windows
constexpr std::ptrdiff_t most_moved = 3;  // strokes that are moved together
constexpr double least_saved = 1e-9;

dvec2 first_of(In<Stop> strokes, const Turn& turn) {
    return turn.reversed ? strokes[turn.stroke].end : strokes[turn.stroke].start;
}

dvec2 last_of(In<Stop> strokes, const Turn& turn) {
    return turn.reversed ? strokes[turn.stroke].start : strokes[turn.stroke].end;
}

/// Where strokes begin and end along a plan; one more before the first, home, and none after the last.
class Plan {
   public:
    Plan(In<Stop> strokes, std::vector<Turn> turns, const dvec2& home, std::size_t trials)
        : strokes_(strokes),
          turns_(std::move(turns)),
          home_(home),
          count_(std::ptrdiff_t(turns_.size())),
          trials_(std::ptrdiff_t(trials)),
          window_(std::clamp(trials_ / std::ptrdiff_t(shared * std::max<std::size_t>(turns_.size(), 1)), narrowest,
                             widest)) {}

    /// Whether turning a part of the way around shortens it anywhere.
    bool turn_parts() {
        bool any = false;
        for (std::ptrdiff_t i = 0; i < count_ && may_try(); ++i)
            for (std::ptrdiff_t j = i; j < std::min(count_, i + window_); ++j, --trials_) {
                const double before = gap(i) + gap(j + 1);
                const double after = glm::distance(last(i - 1), last(j)) + to_next(first(i), j + 1);
                if (after > before - least_saved) continue;
                reverse(i, j);
                any = true;
            }
        return any;
    }

    /// Whether moving a few strokes to another place shortens it anywhere.
    bool move_parts() {
        bool any = false;
        for (std::ptrdiff_t size = 1; size <= most_moved; ++size)
            for (std::ptrdiff_t i = 0; i + size <= count_ && may_try(); ++i) any = move(i, i + size - 1) || any;
        return any;
    }

    std::vector<Turn> turns() { return std::move(turns_); }

   private:
    bool may_try() const {
        Cancelling::poll();
        return trials_ > 0;
    }
    dvec2 first(std::ptrdiff_t i) const { return first_of(strokes_, turns_[i]); }
    dvec2 last(std::ptrdiff_t i) const { return i < 0 ? home_ : last_of(strokes_, turns_[i]); }
    /// Length of the way from a place to stroke i; 0 after the last.
    double to_next(const dvec2& from, std::ptrdiff_t i) const {
        return i < count_ ? glm::distance(from, first(i)) : 0.0;
    }
    /// And that before stroke i.
    double gap(std::ptrdiff_t i) const { return to_next(last(i - 1), i); }

    void reverse(std::ptrdiff_t i, std::ptrdiff_t j) {
        trials_ -= j - i;
        std::reverse(turns_.begin() + i, turns_.begin() + j + 1);
        for (std::ptrdiff_t k = i; k <= j; ++k) turns_[k].reversed = !turns_[k].reversed;
    }

    bool move(std::ptrdiff_t i, std::ptrdiff_t j) {
        const double taken = gap(i) + gap(j + 1) - to_next(last(i - 1), j + 1);
        if (taken <= least_saved) return false;
        double best = taken - least_saved;
        std::ptrdiff_t place = -1;
        bool turned = false;
        const std::ptrdiff_t from = std::max<std::ptrdiff_t>(0, i - window_);
        const std::ptrdiff_t to = std::min(count_, j + 1 + window_);
        trials_ -= to - from;
        for (std::ptrdiff_t k = from; k <= to; ++k) {  // before stroke k
            if (k >= i && k <= j + 1) continue;
            const double whole = gap(k);
            const double added = glm::distance(last(k - 1), first(i)) + to_next(last(j), k) - whole;
            const double added_turned = glm::distance(last(k - 1), last(j)) + to_next(first(i), k) - whole;
            if (std::min(added, added_turned) >= best) continue;
            best = std::min(added, added_turned);
            turned = added_turned < added;
            place = k;
        }
        if (place < 0) return false;
        if (turned) reverse(i, j);
        const auto at = [&](std::ptrdiff_t k) { return turns_.begin() + k; };
        if (place < i)
            std::rotate(at(place), at(i), at(j + 1));
        else
            std::rotate(at(i), at(j + 1), at(place));
        return true;
    }

    In<Stop> strokes_;
    std::vector<Turn> turns_;
    dvec2 home_;
    std::ptrdiff_t count_, trials_, window_;
};

}  // namespace

std::vector<Turn> nearest_order(In<Stop> strokes, const dvec2& home) {
    if (strokes.empty()) return {};
    dvec2 low = home, high = home;
    for (const Stop& s : strokes) {
        low = glm::min(low, glm::min(s.start, s.end));
        high = glm::max(high, glm::max(s.start, s.end));
    }
    const dvec2 size = high - low;
    const double side = std::max({size.x, size.y, 1e-6});
    PointGrid grid(side / std::max(1.0, std::sqrt(2.0 * double(strokes.size()) / points_per_cell)));
    for (std::size_t i = 0; i < strokes.size(); ++i) {
        grid.add(strokes[i].start, 2 * i);
        grid.add(strokes[i].end, 2 * i + 1);
    }
    const int most_rings = int(std::ceil(side / grid.cell())) + 2;
    std::vector<bool> done(strokes.size());
    std::vector<Turn> plan;
    dvec2 at = home;
    while (plan.size() < strokes.size()) {
        Cancelling::poll();
        double nearest = std::numeric_limits<double>::infinity();
        std::size_t best = 0;
        for (int ring = 0; ring <= most_rings && nearest > (ring - 1) * grid.cell(); ++ring)
            grid.at_ring(at, ring, [&](std::size_t end) {
                const Stop& s = strokes[end / 2];
                if (done[end / 2]) return;
                const double distance = glm::distance(at, end % 2 ? s.end : s.start);
                if (distance > nearest || (distance == nearest && end > best)) return;
                nearest = distance;
                best = end;
            });
        plan.push_back({best / 2, best % 2 == 1});
        done[best / 2] = true;
        at = last_of(strokes, plan.back());
    }
    return plan;
}

std::vector<Turn> plot_order(In<Stop> strokes, const dvec2& home, std::size_t trials) {
    Plan plan(strokes, nearest_order(strokes, home), home, trials);
    for (int round = 0; round < most_passes; ++round) {
        const bool turned = plan.turn_parts(), moved = plan.move_parts();
        if (!turned && !moved) break;
    }
    return plan.turns();
}

double way_between(In<Stop> strokes, const std::vector<Turn>& plan, const dvec2& home) {
    double way = 0.0;
    dvec2 at = home;
    for (const Turn& turn : plan) {
        way += glm::distance(at, first_of(strokes, turn));
        at = last_of(strokes, turn);
    }
    return way;
}

}  // namespace fovea::vector
