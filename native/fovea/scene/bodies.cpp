// SPDX-License-Identifier: GPL-3.0-or-later
#include <fovea/scene/bodies.h>

#include <algorithm>

#include <fovea/base/disjoint_sets.h>
#include <fovea/base/parallel.h>

namespace fovea::scene {

Bodies::Bodies(const Surface& surface) : of_facet(surface.facet_count(), none) {
    Array<std::uint8_t> hides(surface.facet_count(), 0);
    for (Index t = 0; t < surface.occluding_triangles; ++t) hides[surface.triangle_facet[t]] = 1;
    const auto each_side = [&](Index edge, const auto& body) {
        for (const EdgeSide side : surface.sides(edge))
            if (hides[side.facet()]) body(side);
    };
    const auto edge_count = static_cast<Index>(surface.edges.size());
    DisjointSets sets(surface.facet_count());
    for (Index e = 0; e < edge_count; ++e) {
        Index first = none;
        each_side(e, [&](EdgeSide side) {
            if (first == none) first = side.facet();
            sets.join(first, side.facet());
        });
    }
    Index count = 0;
    for (Index f = 0; f < of_facet.size(); ++f)
        if (hides[f]) of_facet[f] = sets.name(f) == f ? count++ : of_facet[sets.name(f)];
    solid.assign(count, 1);
    for (Index e = 0; e < edge_count; ++e) {
        int turns = 0;
        Index body = none;
        each_side(e, [&](EdgeSide side) {
            turns += side.forward() ? 1 : -1;
            body = of_facet[side.facet()];
        });
        if (turns != 0) solid[body] = 0;
    }
    Array<double> volume(count, 0.0);
    for (Index t = 0; t < surface.occluding_triangles; ++t) {
        const auto corner = [&](int i) { return dvec3(surface.positions[surface.triangles[t][i]] - surface.center); };
        volume[of_facet[surface.triangle_facet[t]]] += glm::dot(corner(0), glm::cross(corner(1), corner(2)));
    }
    outward = parallel_map<std::uint8_t>(count, [&](std::size_t b) { return solid[b] && volume[b] > 0.0; });
    all_outward = count > 0 && std::ranges::find(outward, 0) == outward.end();
}

std::shared_ptr<const Bodies> bodies_of(const Surface& surface) {
    return surface.cache().get<Bodies>(0, [&] { return Bodies(surface); });
}

SceneBodies bodies_of(const Scene& scene) {
    SceneBodies bodies(scene.placements.size());
    parallel_for(bodies.size(), 1, [&](std::size_t i) {
        if (scene.placements[i].usage & (usage_occlude | usage_holdout))
            bodies[i] = bodies_of(*scene.placements[i].surface);
    });
    return bodies;
}

}  // namespace fovea::scene
