// SPDX-License-Identifier: GPL-3.0-or-later
#include <fovea/runs/touches.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <tbb/enumerable_thread_specific.h>

namespace fovea::runs {
namespace {

/// Places by the cells of a grid, as large as the distance.
class PlaceGrid {
   public:
    PlaceGrid(In<Place> places, double touch_px, bool by_key) : places_(places), touch_(touch_px) {
        for (Index k = 0; k < places.size(); ++k)
            cells_.push_back({by_key ? places[k].key : 0, cell_of(places[k].px.y), cell_of(places[k].px.x), k});
        parallel_sort(cells_.begin(), cells_.end());
    }

    /// Calls near(place, distance, arc) for the places of a key near a run, for each of its segments.
    template <typename Near>
    void along(const ClippedPaths& clipped, const Runs& runs, std::size_t run, Index key, const Near& near) const {
        const Index piece = runs.piece[run];
        const double stop = runs.end_px[run];
        double arc = runs.start_px[run];
        dvec2 before(clipped.place_px(piece, arc));
        for (Index i = clipped.segment_at(piece, arc) + 1;; ++i) {
            const bool inside = i < clipped.pieces.end(piece) && clipped.arc_px[i] < stop;
            const double next = inside ? clipped.arc_px[i] : stop;
            const dvec2 here = inside ? dvec2(clipped.px[i]) : dvec2(clipped.place_px(piece, stop));
            beside(key, before, here,
                   [&](Index place, double distance, double t) { near(place, distance, glm::mix(arc, next, t)); });
            if (!inside) break;
            before = here;
            arc = next;
        }
    }

   private:
    struct Cell {
        Index key;
        std::int64_t row, column;
        Index place;
        auto operator<=>(const Cell&) const = default;
    };

    /// Calls near(place, distance, fraction of the way) for the places near a straight line from a to b.
    template <typename Near>
    void beside(Index key, const dvec2& a, const dvec2& b, const Near& near) const {
        const dvec2 way = b - a, low = glm::min(a, b) - touch_, high = glm::max(a, b) + touch_;
        if (!std::isfinite(low.x + low.y + high.x + high.y)) return;
        const double square = glm::dot(way, way);
        for (std::int64_t row = cell_of(low.y); row <= cell_of(high.y); ++row) {
            // What is nearest to places of a row lies in it or in one beside it.
            const auto x_at = [&](std::int64_t of, double level) {
                return way.y == 0.0 ? level : a.x + way.x * std::clamp((double(of) * touch_ - a.y) / way.y, 0.0, 1.0);
            };
            const double x0 = x_at(row - 1, a.x), x1 = x_at(row + 2, b.x);
            const std::int64_t last = cell_of(std::max(x0, x1) + touch_);
            auto cell = std::ranges::lower_bound(cells_, Cell{key, row, cell_of(std::min(x0, x1) - touch_), 0});
            if (cell == cells_.end() || cell->key != key) return;
            if (cell->row > row) row = cell->row - 1;  // there is nothing in the rows between
            for (; cell != cells_.end() && cell->key == key && cell->row == row && cell->column <= last; ++cell) {
                const dvec2& px = places_[cell->place].px;
                const double t = square > 0.0 ? std::clamp(glm::dot(px - a, way) / square, 0.0, 1.0) : 0.0;
                const double distance = glm::distance(px, a + t * way);
                if (distance <= touch_) near(cell->place, distance, t);
            }
        }
    }

    /// Places so far away that cells have no numbers are in the last.
    std::int64_t cell_of(double px) const {
        constexpr double last = 1e15;
        return std::int64_t(std::floor(std::clamp(px / touch_, -last, last)));
    }

    In<Place> places_;
    double touch_;
    Array<Cell> cells_;
};

}  // namespace

Array<Touch> touches_of(const ClippedPaths& clipped, const Runs& runs, In<Place> places, In<Index> key,
                        double touch_px) {
    const PlaceGrid grid(places, touch_px, true);
    /// The touch of a place by the run that was looked at last.
    struct Last {
        Index run = none;
        std::size_t touch = 0;
    };
    tbb::enumerable_thread_specific<std::vector<Last>> of_thread([&] { return std::vector<Last>(places.size()); });
    Array<Touch> all =
        parallel_collect<Touch>(runs.size(), runs_per_block, [&](std::size_t r, std::size_t end, auto& part) {
            std::vector<Last>& last = of_thread.local();
            for (; r < end; ++r) {
                if (key[r] == none) continue;
                grid.along(clipped, runs, r, key[r], [&](Index place, double distance, double arc) {
                    const Touch touch{place, Index(r), distance, arc};
                    const auto [run, at] = last[place];
                    // Of many segments that touch it, the nearest one.
                    if (run == r) {
                        part[at] = std::min(part[at], touch);
                        return;
                    }
                    last[place] = {Index(r), part.size()};
                    part.push_back(touch);
                });
            }
        });
    parallel_sort(all.begin(), all.end());
    return all;
}

Array<std::uint8_t> touched_by_others(const ClippedPaths& clipped, const Runs& runs, In<Place> places, In<Index> own,
                                      double touch_px) {
    const PlaceGrid grid(places, touch_px, false);
    Array<std::uint8_t> touched(places.size(), 0);
    parallel_for(runs.size(), runs_per_block, [&](std::size_t r) {
        if (runs.invisibility[r] != 0) return;
        grid.along(clipped, runs, r, 0, [&](Index place, double, double) {
            if (own[place] != r) std::atomic_ref(touched[place]).store(1, std::memory_order_relaxed);
        });
    });
    return touched;
}

}  // namespace fovea::runs
