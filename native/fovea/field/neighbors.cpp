// SPDX-License-Identifier: GPL-3.0-or-later
#include <fovea/field/neighbors.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <limits>

#include <fovea/base/disjoint_sets.h>
#include <fovea/base/elementary.h>
#include <fovea/base/hash.h>
#include <fovea/base/parallel.h>
#include <fovea/mesh/corners.h>

namespace fovea::field {
namespace {

/// Classifies edges as hard: by the angle between their two facets, compared with how much the surface bends next to
/// them. Where it bends there as well, the fold is a rounded one of few triangles, at which neighborhoods must not be
/// cut.
class HardEdges {
   public:
    HardEdges(const Surface& surface, const Lists<Index>& triangles, double hard_angle)
        : surface_(surface), triangles_(triangles), least_cosine_(cosine(glm::radians(std::min(hard_angle, 180.0)))) {}

    /// Per edge of the surface.
    Array<std::uint8_t> find() const {
        auto hard = parallel_map<std::uint8_t>(surface_.edges.size(),
                                               [&](std::size_t e) { return told(Index(e)) || folded(Index(e)); });
        drop_stray(hard);
        return hard;
    }

   private:
    static constexpr double always_hard = glm::radians(75.0), outlier = 6.0;
    static constexpr int stray_length = 3;  // passes, each of which removes the last edge of a chain

    /// Marked sharp, or with more than two facets.
    bool told(Index edge) const {
        return surface_.edge_rows.size(edge) > 2 || (surface_.edge_rows.size(edge) == 2 && edge < surface_.mesh_edges &&
                                                     (surface_.edge_marks[edge] & mark_sharp));
    }

    bool folded(Index edge) const {
        const In<EdgeSide> sides = surface_.sides(edge);
        if (sides.size() != 2) return false;
        const EdgeSide a = sides[0], b = sides[1];
        const dvec3 first = normal(a.facet()), second = normal(b.facet());
        const double cosine = glm::dot(first, second) * (a.forward() == b.forward() ? -1.0 : 1.0);
        if (!(cosine < least_cosine_)) return false;
        const double turn = arc_cosine(std::max(cosine, -1.0));
        return turn > always_hard || turn > outlier * mean_turn_beside(surface_.edges[edge], first, second);
    }

    dvec3 normal(Index facet) const { return dvec3(surface_.facet_plane[facet]); }
    /// Drops folds that do not continue at both ends (noise), from the ends of chains inwards, `stray_length` times. A
    /// border counts as a continuation.
    void drop_stray(Array<std::uint8_t>& hard) const {
        Array<Index> folds = parallel_where(hard.size(), [&](Index e) { return hard[e] != 0; });
        if (folds.empty()) return;
        const Array<Index> borders =
            parallel_where(hard.size(), [&](Index e) { return !hard[e] && surface_.edge_rows.size(e) == 1; });
        for (int pass = 0; pass < stray_length && !folds.empty(); ++pass) {
            Array<std::uint8_t> more(surface_.vertex_count(), 0);  // edges that end at the vertex: 0, 1, or 2 for more
            const auto end_at = [&](Index v) { more[v] = more[v] ? 2 : 1; };
            for (const In<Index> ending : {In<Index>(folds), In<Index>(borders)})
                for (const Index e : ending) end_at(surface_.edges[e].x), end_at(surface_.edges[e].y);
            std::erase_if(folds, [&](Index e) {
                const bool stray = !told(e) && (more[surface_.edges[e].x] < 2 || more[surface_.edges[e].y] < 2);
                if (stray) hard[e] = 0;
                return stray;
            });
        }
    }

    /// Mean angle between the triangles around both ends and whichever of the edge's two facets is closer in direction.
    double mean_turn_beside(Edge edge, const dvec3& first, const dvec3& second) const {
        double sum = 0.0;
        Index count = 0;
        for (const Index v : {edge.x, edge.y})
            for (const Index t : triangles_[v]) {
                const dvec3 n = normal(surface_.triangle_facet[t]);
                ++count;
                sum += arc_cosine(std::clamp(std::max(glm::dot(n, first), glm::dot(n, second)), -1.0, 1.0));
            }
        return count ? sum / count : 0.0;
    }

    const Surface& surface_;
    const Lists<Index>& triangles_;
    double least_cosine_;
};

/// Whether two triangles at vertex v share a side at v that is not a hard edge (`hard_ends`: their other ends).
bool joined(const Surface& surface, Index v, Index a, Index b, In<Index> hard_ends) {
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j) {
            const Index w = surface.triangles[a][i];
            if (w == v || w != surface.triangles[b][j]) continue;
            if (std::ranges::find(hard_ends, w) == hard_ends.end()) return true;
        }
    return false;
}

/// Splits the triangles around a vertex into sectors at hard edges, moves the sector of the largest angle to the front
/// of `triangles` (order preserved) and returns its size.
Index keep_largest_sector(const Surface& surface, Index v, In<Index> hard_ends, std::span<Index> triangles) {
    const Index n = static_cast<Index>(triangles.size());
    DisjointSets sectors(n);
    for (Index i = 0; i < n; ++i)
        for (Index j = 0; j < i; ++j)
            if (sectors.name(i) != sectors.name(j) && joined(surface, v, triangles[i], triangles[j], hard_ends))
                sectors.join(i, j);
    Array<double> angle(n, 0.0);
    for (Index i = 0; i < n; ++i) angle[sectors.name(i)] += corner_angle(surface, triangles[i], v);
    Index best = 0;
    for (Index i = 1; i < n; ++i)
        if (angle[i] > angle[best] * (1.0 + 1e-5)) best = i;
    Index kept = 0;
    for (Index i = 0; i < n; ++i)
        if (sectors.name(i) == best) triangles[kept++] = triangles[i];
    return kept;
}

/// Reduces the triangles of each vertex with hard edges (given by their other ends) to one sector; returns the counts.
Array<Index> kept_triangles(const Surface& surface, const Lists<Index>& hard_ends, Lists<Index>& triangles) {
    return parallel_map<Index>(triangles.count(), [&](std::size_t i) {
        const Index v = static_cast<Index>(i);
        return hard_ends.size(v) == 0 ? triangles.size(v) : keep_largest_sector(surface, v, hard_ends[v], triangles[v]);
    });
}

/// The vertices that follow vertex v in the triangles around it, and those that precede it, if there are few triangles.
struct Fan {
    static constexpr int most = 8;
    static constexpr int beyond = std::numeric_limits<int>::max();  // more than any index

    Fan(const Surface& surface, Index v, In<Index> triangles) {
        for (auto* ends : {&next, &previous}) std::fill_n(ends->data(), most, beyond);
        for (std::size_t i = 0; i < triangles.size(); ++i) {
            const Triangle& t = surface.triangles[triangles[i]];
            next[i] = static_cast<int>(t.x == v ? t.y : t.y == v ? t.z : t.x);
            previous[i] = static_cast<int>(t.x == v ? t.z : t.y == v ? t.x : t.y);
        }
    }
    /// In ascending order; `beyond` at the end, and where one occurs twice. The place of each is how many are less,
    /// which takes no branches.
    static std::array<int, most> sorted(const std::array<int, most>& ends) {
        std::array<int, most> less{};
        for (int j = 0; j < most; ++j)
            for (int i = 0; i < most; ++i) less[i] += ends[j] < ends[i];
        std::array<int, most> placed;
        placed.fill(beyond);
        for (int i = 0; i < most; ++i) placed[less[i]] = ends[i];
        return placed;
    }

    std::array<int, most> next, previous;
};

/// Writes the vertices of triangles around v but v itself in ascending order to `out`, which has room for two of each
/// triangle; returns how many they are.
Index list_ends(const Surface& surface, Index v, In<Index> triangles, Index* out) {
    const std::size_t size = triangles.size();
    if (size <= Fan::most) {
        const Fan fan(surface, v, triangles);
        const auto next = Fan::sorted(fan.next);
        const auto is_end = [&](int w) { return w != Fan::beyond && w != static_cast<int>(v); };
        if (next == Fan::sorted(fan.previous) && std::all_of(next.begin(), next.begin() + size, is_end)) {
            std::copy_n(next.begin(), size, out);  // they go all around v
            return static_cast<Index>(size);
        }
    }
    Index* end = out;
    for (const Index t : triangles)
        for (int k = 0; k < 3; ++k)
            if (const Index w = surface.triangles[t][k]; w != v) *end++ = w;
    std::sort(out, end);
    return static_cast<Index>(std::unique(out, end) - out);
}

Neighbors find_neighbors(const Surface& surface, double hard_angle) {
    Neighbors result;
    const Index count = surface.vertex_count();
    Lists<Index> around = lists_of_ranges<Index>(count, [&](const auto& give) {
        for (Index t = 0; t < surface.triangles.size(); ++t)
            for (int i = 0; i < 3; ++i) give(surface.triangles[t][i], t);
    });
    result.hard.assign(count, 0);
    if (hard_angle < no_hard_edges) {
        const Array<std::uint8_t> is_hard = HardEdges(surface, around, hard_angle).find();
        const auto ends = lists_of_ranges<Index>(count, [&](const auto& give) {
            for (std::size_t e = 0; e < is_hard.size(); ++e) {
                if (!is_hard[e]) continue;
                give(surface.edges[e].x, surface.edges[e].y);
                give(surface.edges[e].y, surface.edges[e].x);
            }
        });
        parallel_for(count, [&](std::size_t v) { result.hard[v] = ends.size(Index(v)) > 0; });
        if (!ends.values.empty())
            around = lists_from(kept_triangles(surface, ends, around), [&](Index v) { return around[v].begin(); });
    }
    result.triangles = std::move(around);
    // Vertices of these triangles: at most two for each of them.
    Array<Index> listed(2 * result.triangles.values.size()), counts(count);
    const auto listed_at = [&](Index v) { return listed.data() + 2 * std::size_t(result.triangles.begin(v)); };
    parallel_for(count, [&](std::size_t v) {
        counts[v] = list_ends(surface, Index(v), In<Index>(result.triangles[Index(v)]), listed_at(Index(v)));
    });
    result.vertices = lists_from(std::move(counts), listed_at);
    return result;
}

}  // namespace

std::shared_ptr<const Neighbors> neighbors_of(const Surface& surface, double hard_angle) {
    return surface.cache().get<Neighbors>(hash_numbers(std::bit_cast<std::uint64_t>(hard_angle)),
                                          [&] { return find_neighbors(surface, hard_angle); });
}

}  // namespace fovea::field
