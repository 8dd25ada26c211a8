#include "path/doubles.h"

#include <algorithm>
#include <atomic>
#include <cmath>

#include "base/parallel.h"
#include "field/fields.h"
#include "mesh/triangle_sides.h"
#include "path/hysteresis.h"

namespace fovea {
namespace {

/// An edge between two facets that the smooth surface does not go around.
bool is_hard(const Surface& surface, Index edge) {
    static const double hard = std::cos(glm::radians(default_hard_angle));
    const Index begin = surface.edge_rows.begin(edge);
    if (surface.edge_rows.size(edge) != 2) return true;
    const auto normal = [&](Index side) { return vec3(surface.facet_plane[surface.edge_sides[side].facet()]); };
    return glm::dot(normal(begin), normal(begin + 1)) <= hard;
}

/// Marks the corners of the triangles for which `wanted` holds.
template <typename Wanted>
Array<std::uint8_t> mark_corners(const Surface& surface, const Wanted& wanted) {
    Array<std::uint8_t> marked(surface.vertex_count(), 0);
    parallel_for(surface.triangles.size(), [&](std::size_t t) {
        if (!wanted(surface.triangles[t])) return;
        for (int i = 0; i < 3; ++i)
            std::atomic_ref(marked[surface.triangles[t][i]]).store(1, std::memory_order_relaxed);
    });
    return marked;
}

/// Marks the triangles where the chain runs for long with at least so many corners near.
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

CurveChains Claims::claim(const LineDefinition& definition, CurveChains chains) {
    Array<std::uint8_t>& taken = taken_[definition.part_of ? definition.part_of : &definition];
    if (!taken.empty()) chains = without_triangles(chains, taken);
    taken.resize(surface_.triangles.size(), 0);
    for (Index triangle : chains.triangle) taken[triangle] = 1;
    return chains;
}

Array<std::uint8_t> near_smooth_contour(const SurfaceView& seen) {
    const Surface& surface = seen.surface;
    const auto fields = fields_of(surface);
    Array<std::uint8_t> front(surface.vertex_count());
    parallel_for(front.size(), [&](std::size_t v) {
        front[v] = glm::dot(fields->curvature[v].normal, seen.to_viewer(static_cast<Index>(v))) >= 0.0f;
    });
    const Array<std::uint8_t> at = mark_corners(
        surface, [&](const Triangle& t) { return front[t.x] != front[t.y] || front[t.y] != front[t.z]; });
    return mark_corners(surface, [&](const Triangle& t) { return at[t.x] || at[t.y] || at[t.z]; });
}

void drop_doubled_edges(const Surface& surface, In<std::uint8_t> near, Kinds bits, Array<Kinds>& kinds) {
    parallel_for(kinds.size(), [&](std::size_t e) {
        const Edge edge = surface.edges[e];
        if (!(kinds[e] & bits) || !near[edge.x] || !near[edge.y]) return;
        if (!is_hard(surface, static_cast<Index>(e))) kinds[e] &= ~bits;
    });
}

Array<std::uint8_t> at_hard_edges(const Surface& surface, Kinds bits, In<Kinds> kinds) {
    Array<std::uint8_t> at(surface.vertex_count(), 0);
    parallel_for(kinds.size(), [&](std::size_t e) {
        if (!(kinds[e] & bits) || !is_hard(surface, static_cast<Index>(e))) return;
        for (Index v : {surface.edges[e].x, surface.edges[e].y})
            std::atomic_ref(at[v]).store(1, std::memory_order_relaxed);
    });
    return at;
}

CurveChains without_doubles(const CurveChains& chains, const Surface& surface, In<std::uint8_t> near, int corners) {
    const auto sides = triangle_sides(surface);
    // Chains of one level share no triangle, and curves that run along contours have but one.
    Array<std::uint8_t> removed(surface.triangles.size(), 0);
    parallel_for(
        chains.rows.count(),
        [&](std::size_t c) {
            mark_long_stretches(chains, static_cast<Index>(c), surface, *sides, near, corners, removed);
        },
        16);
    return without_triangles(chains, removed);
}

}  // namespace fovea
