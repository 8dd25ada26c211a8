// SPDX-License-Identifier: GPL-3.0-or-later
#include <fovea/project/backs.h>

#include <algorithm>

#include <fovea/base/check.h>
#include <fovea/line/registry.h>
#include <fovea/scene/section.h>

namespace fovea::project {
namespace {

/// Per placement: its bodies if the viewer sees it cut by the section plane, else null. Empty: none is.
SceneBodies seen_cut(const Scene& scene, const View& view) {
    const auto plane = section_in_view(scene, view);
    if (!plane || !faces_section(*plane, view)) return {};
    SceneBodies cut(scene.placements.size());
    parallel_for(cut.size(), 64, [&](std::size_t i) {
        const Placement& placement = scene.placements[i];
        if (cut_of(scene, placement).kept == Cut::part) cut[i] = bodies_of(*placement.surface);
    });
    return cut;
}

}  // namespace

Backs::Backs(const Scene& scene, const View& view)
    : scene_(scene), cut_(seen_cut(scene, view)), on_fronts_(contours() | kinds_in_section()) {
    const auto& placements = scene.placements;
    if (cut_.empty() &&
        std::ranges::all_of(placements, [](const Placement& p) { return p.surface->polygon_one_sided.empty(); }))
        return;
    const dvec4 eye = view.orthographic ? dvec4(0, 0, 1, 0) : dvec4(0, 0, 0, 1);
    eyes_ = parallel_map<dvec4>(placements.size(), [&](std::size_t i) {
        const bool has_none = placements[i].surface->polygon_one_sided.empty() && (cut_.empty() || !cut_[i]);
        return has_none ? dvec4(0.0) : glm::inverse(view.world_to_view * placements[i].object_to_world) * eye;
    });
}

bool Backs::culled(Index placement, Index facet) const {
    const Surface& surface = *scene_.placements[placement].surface;
    if (surface.culled(facet, eyes_[placement])) return true;
    if (cut_.empty() || !cut_[placement]) return false;
    const Index body = cut_[placement]->of_facet[facet];
    if (body == none || !cut_[placement]->outward[body]) return false;
    const vec4& p = surface.facet_plane[facet];
    return glm::dot(dvec4(p.x, p.y, p.z, -p.w), eyes_[placement]) < 0.0;
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
    if (paths.kinds[point] & on_fronts_) return false;
    if (culled(placement, surface.triangle_facet[surface.triangle_at(place)])) return true;
    const Index facet = paths.other_facet_at(point);
    if (facet == none) return false;
    const auto& base = scene_.facet_base;
    const auto other = static_cast<Index>(std::upper_bound(base.begin(), base.end(), facet) - base.begin() - 1);
    return culled(other, facet - base[other]);
}

}  // namespace fovea::project
