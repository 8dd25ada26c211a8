// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>

#include <fovea/base/check.h>
#include <fovea/runs/filters.h>
#include <fovea/runs/groups.h>
#include <fovea/runs/touches.h>

namespace fovea::runs {
namespace {

constexpr Index any = 0;  // key of all runs

/// Ends of the groups that may be tips: their places in the image, and their groups.
struct TipEnds {
    Array<Place> places;
    Array<Index> group;
};

TipEnds ends_of(const ClippedPaths& clipped, const Runs& runs, const Groups& groups, double tip_px) {
    TipEnds ends;
    for (std::size_t r = 0; r < runs.size(); ++r) {
        const Index group = groups.of_run[r];
        if (group == none || !groups.hidden[group] || groups.size_px[group] >= tip_px) continue;
        for (const double arc : {runs.start_px[r], runs.end_px[r]}) {
            const dvec2 px(clipped.place_px(runs.piece[r], arc));
            if (!std::isfinite(px.x + px.y)) continue;
            ends.places.push_back({px, any});
            ends.group.push_back(group);
        }
    }
    return ends;
}

/// Per group: 1 if it has an end that no group touches but such as are removed themselves.
std::vector<std::uint8_t> loose_groups(const Groups& groups, const TipEnds& ends, In<Touch> touches) {
    std::vector<std::uint8_t> removed(groups.count(), 0);
    for (bool more = true; more;) {
        more = false;
        auto touch = touches.begin();
        for (Index end = 0; end < ends.group.size(); ++end) {
            const Index own = ends.group[end];
            bool held = false;
            for (; touch != touches.end() && touch->place == end; ++touch) {
                const Index group = groups.of_run[touch->run];
                held |= group != none && group != own && !removed[group];
            }
            if (held || removed[own]) continue;
            removed[own] = 1;
            more = true;
        }
    }
    return removed;
}

}  // namespace

Runs without_tips(const ClippedPaths& clipped, const Runs& runs, In<Index> placement, double tip_px, double touch_px) {
    check(tip_px >= 0.0 && touch_px > 0.0, "tip_px, touch_px: not numbers of 0 or more, and above 0");
    const Groups groups = group_runs(clipped, runs, placement, false);
    const TipEnds ends = ends_of(clipped, runs, groups, tip_px);
    if (ends.group.empty()) return runs;
    const auto keys =
        parallel_map<Index>(runs.size(), [&](std::size_t r) { return groups.of_run[r] == none ? none : any; });
    const Array<Touch> touches = touches_of(clipped, runs, ends.places, keys, touch_px);
    const std::vector<std::uint8_t> removed = loose_groups(groups, ends, touches);
    Runs kept;
    for (std::size_t r = 0; r < runs.size(); ++r)
        if (groups.of_run[r] == none || !removed[groups.of_run[r]]) kept.push(runs, r);
    return kept;
}

}  // namespace fovea::runs
