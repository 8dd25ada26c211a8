// SPDX-License-Identifier: GPL-3.0-or-later
#include <fovea/scene/bodies.h>

#include <algorithm>
#include <atomic>
#include <tuple>

#include <fovea/base/disjoint_sets.h>
#include <fovea/base/parallel.h>

namespace fovea::scene {
namespace {

constexpr std::size_t block = 1 << 14;  // edges, facets or triangles that a thread looks at in one go

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
    const auto find = [&](std::size_t begin, std::size_t end, Array<OpenEdge>& out) {
        for (Index e = Index(begin); e < end; ++e)
            if (!is_balanced(surface, e, hides)) out.push_back({surface.edges[e], e, false});
    };
    Array<OpenEdge> open = parallel_collect<OpenEdge>(surface.edges.size(), block, find);
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

/// Six times the signed volume of each of `count` bodies.
Array<double> volumes(const Surface& surface, In<Index> of_facet, std::size_t count) {
    struct Part {
        Index body;
        double volume;
    };
    const auto parts = parallel_collect<Part>(
        surface.occluding_triangles, block, [&](std::size_t begin, std::size_t end, Array<Part>& out) {
            for (std::size_t t = begin; t < end; ++t) {
                const auto corner = [&](int i) {
                    return dvec3(surface.positions[surface.triangles[t][i]] - surface.center);
                };
                const Index body = of_facet[surface.triangle_facet[t]];
                if (out.empty() || out.back().body != body) out.push_back({body, 0.0});
                out.back().volume += glm::dot(corner(0), glm::cross(corner(1), corner(2)));
            }
        });
    Array<double> volume(count, 0.0);
    for (const Part& part : parts) volume[part.body] += part.volume;
    return volume;
}

}  // namespace

Bodies::Bodies(const Surface& surface) : of_facet(surface.facet_count(), none) {
    Array<std::uint8_t> hides(surface.facet_count(), 0);
    parallel_for(surface.occluding_triangles, [&](std::size_t t) {
        std::atomic_ref(hides[surface.triangle_facet[t]]).store(1, std::memory_order_relaxed);
    });
    const auto each_side = [&](Index edge, const auto& body) {
        for (const EdgeSide side : surface.sides(edge))
            if (hides[side.facet()]) body(side);
    };
    DisjointSets sets(surface.facet_count());
    parallel_for(surface.edges.size(), [&](std::size_t e) {
        Index first = none;
        each_side(Index(e), [&](EdgeSide side) {
            if (first == none) first = side.facet();
            sets.join(first, side.facet());
        });
    });
    const Array<OpenEdge> open = open_edges(surface, hides);
    for (std::size_t i = 1; i < open.size(); ++i)
        if (open[i].ends == open[i - 1].ends)
            each_side(open[i].edge, [&](EdgeSide side) {
                each_side(open[i - 1].edge, [&](EdgeSide other) { sets.join(side.facet(), other.facet()); });
            });
    const Array<Index> firsts = parallel_where(of_facet.size(), [&](Index f) { return hides[f] && sets.name(f) == f; });
    const std::size_t count = firsts.size();
    for (Index b = 0; b < count; ++b) of_facet[firsts[b]] = b;
    parallel_for(of_facet.size(), [&](std::size_t f) {
        const Index first = hides[f] ? sets.name(Index(f)) : Index(f);
        if (first != f) of_facet[f] = of_facet[first];
    });
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
    const Array<double> volume = volumes(surface, of_facet, count);
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
