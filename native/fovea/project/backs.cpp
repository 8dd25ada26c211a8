// SPDX-License-Identifier: GPL-3.0-or-later
#include <fovea/project/backs.h>

#include <algorithm>

#include <fovea/base/check.h>
#include <fovea/line/registry.h>

namespace fovea::project {

Backs::Backs(const Scene& scene, const View& view) : scene_(scene), contours_(contours()) {
    const auto& placements = scene.placements;
    if (std::ranges::all_of(placements, [](const Placement& p) { return p.surface->polygon_one_sided.empty(); }))
        return;
    const dvec4 eye = view.orthographic ? dvec4(0, 0, 1, 0) : dvec4(0, 0, 0, 1);
    eyes_ = parallel_map<dvec4>(placements.size(), [&](std::size_t i) {
        const bool two_sided = placements[i].surface->polygon_one_sided.empty();
        return two_sided ? dvec4(0.0) : glm::inverse(view.world_to_view * placements[i].object_to_world) * eye;
    });
}

bool Backs::culled(Index placement, Index facet) const {
    return scene_.placements[placement].surface->culled(facet, eyes_[placement]);
}

bool Backs::hold(const Paths& paths, Index path, Index point) const {
    const Index placement = paths.placement[path], place = paths.place[point];
    if (placement == none) return false;
    const Surface& surface = *scene_.placements[placement].surface;
    check(place < surface.place_count(), "project: the paths are not of this scene");
    if (surface.is_edge(place)) {
        const In<EdgeSide> sides = surface.sides(place);
        return !sides.empty() &&
               std::ranges::all_of(sides, [&](EdgeSide side) { return culled(placement, side.facet()); });
    }
    if (paths.kinds[point] & contours_) return false;
    if (culled(placement, surface.triangle_facet[surface.triangle_at(place)])) return true;
    const Index facet = paths.other_facet_at(point);
    if (facet == none) return false;
    const auto& base = scene_.facet_base;
    const auto other = static_cast<Index>(std::upper_bound(base.begin(), base.end(), facet) - base.begin() - 1);
    return culled(other, facet - base[other]);
}

}  // namespace fovea::project
