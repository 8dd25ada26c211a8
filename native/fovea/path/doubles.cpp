// SPDX-License-Identifier: GPL-3.0-or-later
#include <fovea/path/doubles.h>

#include <algorithm>
#include <atomic>
#include <cmath>

#include <fovea/base/elementary.h>
#include <fovea/base/parallel.h>
#include <fovea/field/fields.h>
#include <fovea/line/smooth_contour.h>
#include <fovea/mesh/triangle_sides.h>
#include <fovea/path/hysteresis.h>

namespace fovea::path {
namespace {

std::shared_ptr<const Neighbors> neighbors_in(const Surface& surface) {
    return neighbors_of(surface, surface.field_options().hard_angle);
}

/// Whether the fitted surface has an edge there, so that no smooth contour runs around it.
bool is_hard(const Surface& surface, const Neighbors& neighbors, Index edge) {
    static const double hard = cosine(glm::radians(default_hard_angle));
    const In<EdgeSide> sides = surface.sides(edge);
    if (sides.size() != 2) return true;
    if (!neighbors.hard[surface.edges[edge].x] || !neighbors.hard[surface.edges[edge].y]) return false;
    const auto normal = [&](EdgeSide side) { return vec3(surface.facet_plane[side.facet()]); };
    return glm::dot(normal(sides[0]), normal(sides[1])) <= hard;
}

/// Marks the triangles of long stretches of a chain with at least `corners` corners near a line.
void mark_long_stretches(const CurveChains& chains, Index chain, const Surface& surface, const TriangleSides& sides,
                         In<std::uint8_t> near, int corners, Array<std::uint8_t>& removed) {
    constexpr double longest = 4.0;
    const auto corners_near = [&](Index i) {
        const Triangle& t = surface.triangles[chains.triangle[i]];
        return (near[t.x] != 0) + (near[t.y] != 0) + (near[t.z] != 0);
    };
    const auto is_near = [&](Index i) { return corners_near(i) >= corners; };
    const auto leads_away = [&](Index i) { return corners_near(i) < std::min(corners + 1, 3); };
    const Index begin = chains.rows.begin(chain), last = chains.rows.end(chain) - 1;
    for (Index i = begin; i < last;) {
        Index j = i;
        double length = 0.0, side = 0.0;
        for (; j < last && is_near(j); ++j) {
            length += glm::distance(chains.point[j], chains.point[j + 1]);
            const Edge e = sides.vertices[sides.of_triangle[chains.triangle[j]].x];
            side += glm::distance(surface.positions[e.x], surface.positions[e.y]);
        }
        const Index next = j + 1;
        if (j > i && length > longest * side / (j - i)) {
            while (i < j && leads_away(i)) ++i;
            while (i < j && leads_away(j - 1)) --j;
            for (; i < j; ++i) removed[chains.triangle[i]] = 1;
        }
        i = next;
    }
}

}  // namespace

CurveChains Claims::claim(const CurveRule& rule, CurveChains chains) {
    Array<std::uint8_t>& taken = taken_[rule.part_of ? &std::get<CurveRule>(rule.part_of->rule) : &rule];
    if (!taken.empty()) chains = without_triangles(chains, taken, true);
    taken.resize(surface_.triangles.size(), 0);
    for (Index triangle : chains.triangle) taken[triangle] = 1;
    return chains;
}

namespace {

/// Per vertex: 1 if it is within two triangles of one of these.
Array<std::uint8_t> within_two(const Surface& surface, In<Index> triangles) {
    const auto neighbors = neighbors_in(surface);
    Array<std::uint8_t> near(surface.vertex_count(), 0);
    Array<Index> at;
    const auto mark = [&](Index triangle, bool first) {
        const Triangle& t = surface.triangles[triangle];
        for (int i = 0; i < 3; ++i) {
            if (first && !near[t[i]]) at.push_back(t[i]);
            near[t[i]] = 1;
        }
    };
    for (const Index triangle : triangles) mark(triangle, true);
    for (const Index v : at)
        for (const Index triangle : neighbors->triangles[v]) mark(triangle, false);
    return near;
}

}  // namespace

Array<std::uint8_t> near_smooth_contour(const SurfaceView& seen, In<std::uint8_t> without) {
    Array<Index> triangles;
    for (const CurvePiece& piece : find_smooth_contour(seen, [](Index) { return 1.0f; }))
        if (without.empty() || !without[piece.triangle]) triangles.push_back(piece.triangle);
    return within_two(seen.surface, triangles);
}

Array<std::uint8_t> near_curves(const Surface& surface, const std::vector<const CurveChains*>& curves) {
    Array<Index> triangles;
    for (const CurveChains* chains : curves)
        triangles.insert(triangles.end(), chains->triangle.begin(), chains->triangle.end());
    Array<std::uint8_t> near = within_two(surface, triangles);
    for (const CurveChains* chains : curves)
        for (Index c = 0; c < chains->rows.count(); ++c)
            if (!chains->closed[c])
                for (const Index i : {chains->rows.begin(c), chains->rows.end(c) - 1})
                    for (int k = 0; k < 3; ++k) near[surface.triangles[chains->triangle[i]][k]] = 0;
    return near;
}

MarkedEdges without_doubled(const MarkedEdges& marked, const Surface& surface, In<std::uint8_t> near,
                            const std::function<Kinds(Index)>& doubled) {
    const auto neighbors = neighbors_in(surface);
    auto left = parallel_map<MarkedEdge>(marked.size(), [&](std::size_t i) {
        MarkedEdge of = marked[i];
        const Edge edge = surface.edges[of.edge];
        const Kinds replaced = near[edge.x] && near[edge.y] ? of.kinds & doubled(of.edge) : 0;
        if (replaced && !is_hard(surface, *neighbors, of.edge)) of.kinds &= ~replaced;
        return of;
    });
    std::erase_if(left, [](const MarkedEdge& of) { return of.kinds == 0; });
    return left;
}

Array<std::uint8_t> at_hard_edges(const Surface& surface, Kinds kinds, const std::vector<MarkedEdges>& of_sets) {
    const auto neighbors = neighbors_in(surface);
    Array<std::uint8_t> at(surface.vertex_count(), 0);
    for (const MarkedEdges& marked : of_sets)
        parallel_for(marked.size(), [&](std::size_t i) {
            const Index e = marked[i].edge;
            if (!(marked[i].kinds & kinds) || !is_hard(surface, *neighbors, e)) return;
            for (Index v : {surface.edges[e].x, surface.edges[e].y})
                std::atomic_ref(at[v]).store(1, std::memory_order_relaxed);
        });
    return at;
}

CurveChains without_doubles(const CurveChains& chains, const Surface& surface, In<std::uint8_t> near, int corners) {
    const auto sides = triangle_sides(surface);
    // Safe in parallel: chains of one level share no triangle, and curves that run along contours have only one level.
    Array<std::uint8_t> removed(surface.triangles.size(), 0);
    parallel_for(chains.rows.count(), 16, [&](std::size_t c) {
        mark_long_stretches(chains, static_cast<Index>(c), surface, *sides, near, corners, removed);
    });
    return without_triangles(chains, removed);
}

}  // namespace fovea::path
