// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <tuple>

#include <fovea/base/check.h>
#include <fovea/runs/filters.h>
#include <fovea/runs/groups.h>

namespace fovea::runs {
namespace {

using Cell = std::pair<std::int64_t, std::int64_t>;

/// An end of a small group, and its cell in a grid.
struct End {
    Cell cell;
    Index group;
    dvec2 px;
    Index number = 0;
};

/// Another group touches an end.
struct Touch {
    Index end, group;
    auto operator<=>(const Touch&) const = default;
};

double distance_to(const dvec2& p, const dvec2& a, const dvec2& b) {
    const dvec2 way = b - a;
    const double square = glm::dot(way, way);
    return glm::distance(p, a + way * (square > 0.0 ? std::clamp(glm::dot(p - a, way) / square, 0.0, 1.0) : 0.0));
}

/// Ends of the groups that may be tips, sorted by cells of `touch_px`.
Array<End> ends_of(const ClippedPaths& clipped, const Runs& runs, const Groups& groups, double tip_px,
                   double touch_px) {
    Array<End> ends;
    for (std::size_t r = 0; r < runs.size(); ++r) {
        const Index group = groups.of_run[r];
        if (group == none || !groups.hidden[group] || groups.size_px[group] >= tip_px) continue;
        for (const double arc : {runs.start_px[r], runs.end_px[r]}) {
            const dvec2 px(clipped.place_px(runs.piece[r], arc));
            if (!std::isfinite(px.x + px.y)) continue;
            ends.push_back(
                {{std::int64_t(std::floor(px.y / touch_px)), std::int64_t(std::floor(px.x / touch_px))}, group, px});
        }
    }
    std::ranges::stable_sort(ends, {}, &End::cell);
    for (Index k = 0; k < ends.size(); ++k) ends[k].number = k;
    return ends;
}

/// The groups other than an end's own that have a run within `touch_px` of it, sorted by ends.
Array<Touch> touches_of(const ClippedPaths& clipped, const Runs& runs, const Groups& groups, const Array<End>& ends,
                        double touch_px) {
    const auto add = [&](const dvec2& a, const dvec2& b, Index group, Array<Touch>& out) {
        const dvec2 low = glm::floor((glm::min(a, b) - touch_px) / touch_px);
        const dvec2 high = glm::floor((glm::max(a, b) + touch_px) / touch_px);
        if (!std::isfinite(low.x + low.y + high.x + high.y)) return;
        for (auto row = std::int64_t(low.y); row <= std::int64_t(high.y); ++row) {
            auto end = std::ranges::lower_bound(ends, Cell(row, std::int64_t(low.x)), {}, &End::cell);
            for (; end != ends.end() && end->cell <= Cell(row, std::int64_t(high.x)); ++end)
                if (end->group != group && distance_to(end->px, a, b) <= touch_px) out.push_back({end->number, group});
        }
    };
    Array<Touch> all = parallel_collect<Touch>(runs.size(), 256, [&](std::size_t r, std::size_t last, auto& part) {
        for (; r < last; ++r) {
            if (groups.of_run[r] == none) continue;
            const Index piece = runs.piece[r];
            const double start = runs.start_px[r], stop = runs.end_px[r];
            dvec2 before(clipped.place_px(piece, start));
            Index i = clipped.segment_at(piece, start) + 1;
            for (; i < clipped.pieces.end(piece) && clipped.arc_px[i] < stop; ++i) {
                const dvec2 here(clipped.px[i]);
                add(before, here, groups.of_run[r], part);
                before = here;
            }
            add(before, dvec2(clipped.place_px(piece, stop)), groups.of_run[r], part);
        }
    });
    parallel_sort(all.begin(), all.end());
    return all;
}

/// Per group: 1 if it has an end that no group touches but such as are removed themselves.
std::vector<std::uint8_t> loose_groups(const Groups& groups, const Array<End>& ends, In<Touch> touches) {
    std::vector<std::uint8_t> removed(groups.count(), 0);
    for (bool more = true; more;) {
        more = false;
        auto touch = touches.begin();
        for (const End& end : ends) {
            bool held = false;
            for (; touch != touches.end() && touch->end == end.number; ++touch) held |= !removed[touch->group];
            if (held || removed[end.group]) continue;
            removed[end.group] = 1;
            more = true;
        }
    }
    return removed;
}

}  // namespace

Runs without_tips(const ClippedPaths& clipped, const Runs& runs, In<Index> placement, double tip_px, double touch_px) {
    check(tip_px >= 0.0 && touch_px > 0.0, "tip_px, touch_px: not numbers of 0 or more, and above 0");
    const Groups groups = group_runs(clipped, runs, placement, false);
    const Array<End> ends = ends_of(clipped, runs, groups, tip_px, touch_px);
    if (ends.empty()) return runs;
    const Array<Touch> touches = touches_of(clipped, runs, groups, ends, touch_px);
    const std::vector<std::uint8_t> removed = loose_groups(groups, ends, touches);
    Runs kept;
    for (std::size_t r = 0; r < runs.size(); ++r)
        if (groups.of_run[r] == none || !removed[groups.of_run[r]]) kept.push(runs, r);
    return kept;
}

}  // namespace fovea::runs
