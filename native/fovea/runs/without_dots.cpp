// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <utility>

#include <fovea/base/check.h>
#include <fovea/runs/dots.h>
#include <fovea/runs/groups.h>
#include <fovea/scene/bodies.h>

namespace fovea::runs {
namespace {

/// A component of a placement's surface.
using Body = std::pair<Index, Index>;

/// `none`, where a path is not on a facet that hides anything.
Body body_of(const Paths& paths, const Scene& scene, Index path) {
    const Index placement = paths.placement[path], place = paths.place[paths.rows.begin(path)];
    const Surface& surface = *scene.placements[placement].surface;
    const bool on_edge = surface.is_edge(place);
    if (on_edge && surface.sides(place).empty()) return {placement, none};
    const Index facet = on_edge ? surface.sides(place)[0].facet() : surface.triangle_facet[surface.triangle_at(place)];
    return {placement, scene::bodies_of(surface)->of_facet[facet]};
}

}  // namespace

Runs without_dots(const ClippedPaths& clipped, const Runs& visible, const Paths& paths, const Scene& scene,
                  double dot_px) {
    check(dot_px >= 0.0, "dot_px: not a number of 0 or more");
    const Groups groups = group_runs(clipped, visible, paths.placement, true);
    const auto is_dot = [&](std::size_t r) {
        const Index group = groups.of_run[r], path = clipped.path[visible.piece[r]];
        return group != none && groups.size_px[group] < dot_px && !groups.hidden[group] && paths.closed[path] &&
               paths.of_view[path];
    };
    Array<std::pair<Body, std::size_t>> dots;
    Array<std::uint8_t> has_dots(scene.placements.size(), 0);
    for (std::size_t r = 0; r < visible.size(); ++r) {
        if (!is_dot(r)) continue;
        const Body body = body_of(paths, scene, clipped.path[visible.piece[r]]);
        if (body.second == none) continue;
        dots.push_back({body, r});
        has_dots[body.first] = 1;
    }
    if (dots.empty()) return visible;
    std::sort(dots.begin(), dots.end());

    // The bodies of dots of which larger lines are seen.
    Array<std::uint8_t> removed(visible.size(), 0);
    for (std::size_t r = 0; r < visible.size(); ++r) {
        const Index group = groups.of_run[r], path = clipped.path[visible.piece[r]];
        if (group == none || groups.size_px[group] < dot_px || !has_dots[paths.placement[path]]) continue;
        const Body body = body_of(paths, scene, path);
        auto dot = std::lower_bound(dots.begin(), dots.end(), std::pair(body, std::size_t(0)));
        for (; dot != dots.end() && dot->first == body && !removed[dot->second]; ++dot) removed[dot->second] = 1;
    }
    Runs kept;
    for (std::size_t r = 0; r < visible.size(); ++r)
        if (!removed[r]) kept.push(visible, r);
    return kept;
}

}  // namespace fovea::runs
