#include "mesh/bodies.h"

#include <algorithm>
#include <numeric>

namespace fovea {
namespace {

/// Facets that belong together: each has another of its group as parent, the last one itself.
struct Groups {
    Array<Index> parent;

    explicit Groups(Index count) : parent(count) { std::iota(parent.begin(), parent.end(), Index(0)); }

    Index of(Index i) {
        while (parent[i] != i) i = parent[i] = parent[parent[i]];
        return i;
    }
    void join(Index a, Index b) { parent[std::max(of(a), of(b))] = std::min(of(a), of(b)); }
};

Bodies find(const Surface& surface) {
    const Index facets = surface.facet_count();
    Groups groups(facets);
    for (Index e = 0; e < surface.edges.size(); ++e)
        for (Index s = surface.edge_rows.begin(e) + 1; s < surface.edge_rows.end(e); ++s)
            groups.join(surface.edge_sides[s - 1].facet(), surface.edge_sides[s].facet());

    Bodies result;
    result.of_facet.assign(facets, 1);  // first of the groups, by the facet that stands for each
    for (Index e = 0; e < surface.edges.size(); ++e) {
        const Index begin = surface.edge_rows.begin(e), sides = surface.edge_rows.size(e);
        if (sides == 0) continue;
        const EdgeSide* side = &surface.edge_sides[begin];
        if (sides != 2 || side[0].forward() == side[1].forward()) result.of_facet[groups.of(side[0].facet())] = 0;
    }
    Array<double> volume(facets, 0.0);
    for (Index t = 0; t < surface.triangles.size(); ++t) {
        const Index group = groups.of(surface.triangle_facet[t]);
        if (t >= surface.occluding_triangles) result.of_facet[group] = 0;
        const auto corner = [&](int i) { return dvec3(surface.positions[surface.triangles[t][i]] - surface.center); };
        volume[group] += glm::dot(corner(0), glm::cross(corner(1), corner(2)));
    }
    result.all = facets > 0;
    for (Index f = 0; f < facets; ++f) {  // a group's facet comes before the others
        const Index group = groups.of(f);
        if (group == f && !(volume[f] > 0.0)) result.of_facet[f] = 0;
        result.of_facet[f] = result.of_facet[group];
        result.all = result.all && result.of_facet[f];
    }
    return result;
}

}  // namespace

std::shared_ptr<const Bodies> bodies(const Surface& surface) {
    return surface.cache().get<Bodies>(0, [&] { return find(surface); });
}

}  // namespace fovea
