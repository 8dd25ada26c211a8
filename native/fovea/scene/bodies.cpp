// SPDX-License-Identifier: GPL-3.0-or-later
#include <fovea/scene/bodies.h>

#include <algorithm>
#include <tuple>

#include <fovea/base/disjoint_sets.h>
#include <fovea/base/parallel.h>

namespace fovea::scene {
namespace {

/// Whether as many of the sides of an edge run one way as the other.
bool is_balanced(const Surface& surface, Index edge, In<std::uint8_t> hides) {
    int turns = 0;
    for (const EdgeSide side : surface.sides(edge))
        if (hides[side.facet()]) turns += side.forward() ? 1 : -1;
    return turns == 0;
}

/// An edge at which a surface is open: its ends, of vertices in one place the first, in ascending order.
struct OpenEdge {
    Edge ends;
    Index edge;
    bool reversed;  ///< against the edge
};

/// The open edges, those in one place beside each other: where a mesh is split along texture seams and hard edges, as
/// files for games are, the surface goes on. Without those of no length.
Array<OpenEdge> open_edges(const Surface& surface, In<std::uint8_t> hides) {
    Array<OpenEdge> open;
    for (Index e = 0; e < surface.edges.size(); ++e)
        if (!is_balanced(surface, e, hides)) open.push_back({surface.edges[e], e, false});
    Array<Index> vertices;
    for (const OpenEdge& o : open) vertices.insert(vertices.end(), {o.ends.x, o.ends.y});
    const auto position = [&](Index v) {
        const vec3& p = surface.positions[v];
        return std::tuple(p.x, p.y, p.z);
    };
    parallel_sort(vertices.begin(), vertices.end(),
                  [&](Index a, Index b) { return std::tuple(position(a), a) < std::tuple(position(b), b); });
    Array<Index> first(surface.vertex_count(), none);
    for (std::size_t i = 0; i < vertices.size(); ++i)
        first[vertices[i]] =
            i > 0 && position(vertices[i]) == position(vertices[i - 1]) ? first[vertices[i - 1]] : vertices[i];
    for (OpenEdge& o : open) {
        o.ends = {first[o.ends.x], first[o.ends.y]};
        o.reversed = o.ends.x > o.ends.y;
        if (o.reversed) std::swap(o.ends.x, o.ends.y);
    }
    std::erase_if(open, [](const OpenEdge& o) { return o.ends.x == o.ends.y; });
    const auto key = [](const OpenEdge& o) { return std::tuple(o.ends.x, o.ends.y, o.edge); };
    parallel_sort(open.begin(), open.end(), [&](const OpenEdge& a, const OpenEdge& b) { return key(a) < key(b); });
    return open;
}

}  // namespace

Bodies::Bodies(const Surface& surface) : of_facet(surface.facet_count(), none) {
    Array<std::uint8_t> hides(surface.facet_count(), 0);
    for (Index t = 0; t < surface.occluding_triangles; ++t) hides[surface.triangle_facet[t]] = 1;
    const auto each_side = [&](Index edge, const auto& body) {
        for (const EdgeSide side : surface.sides(edge))
            if (hides[side.facet()]) body(side);
    };
    DisjointSets sets(surface.facet_count());
    for (Index e = 0; e < surface.edges.size(); ++e) {
        Index first = none;
        each_side(e, [&](EdgeSide side) {
            if (first == none) first = side.facet();
            sets.join(first, side.facet());
        });
    }
    const Array<OpenEdge> open = open_edges(surface, hides);
    for (std::size_t i = 1; i < open.size(); ++i)
        if (open[i].ends == open[i - 1].ends)
            each_side(open[i].edge, [&](EdgeSide side) {
                each_side(open[i - 1].edge, [&](EdgeSide other) { sets.join(side.facet(), other.facet()); });
            });
    Index count = 0;
    for (Index f = 0; f < of_facet.size(); ++f)
        if (hides[f]) of_facet[f] = sets.name(f) == f ? count++ : of_facet[sets.name(f)];
    solid.assign(count, 1);
    for (std::size_t i = 0; i < open.size();) {
        int turns = 0;
        Index body = none;
        const Edge ends = open[i].ends;
        for (; i < open.size() && open[i].ends == ends; ++i)
            each_side(open[i].edge, [&](EdgeSide side) {
                turns += side.forward() != open[i].reversed ? 1 : -1;
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
