// SPDX-License-Identifier: GPL-3.0-or-later
#include <fovea/field/neighbours.h>

#include <algorithm>
#include <atomic>
#include <bit>
#include <cmath>

#include <fovea/base/hash.h>
#include <fovea/base/parallel.h>

namespace fovea {
namespace {

void add_one(Index& count) { std::atomic_ref(count).fetch_add(1, std::memory_order_relaxed); }
Index take_one(Index& next) { return std::atomic_ref(next).fetch_add(1, std::memory_order_relaxed); }

/// Rows that list `values` by key; each row is sorted, so the order of filling does not show.
/// visit(i, give) calls give(key, value) for element i.
template <typename Visit>
void sort_into_rows(Index keys, std::size_t count, const Visit& visit, Rows& rows, Array<Index>& values) {
    rows.offsets.assign(keys, 0);
    parallel_for(count, [&](std::size_t i) { visit(i, [&](Index key, Index) { add_one(rows.offsets[key]); }); });
    counts_to_offsets(rows.offsets);
    values.resize(rows.offsets.back());
    Array<Index> next(rows.offsets.begin(), rows.offsets.end() - 1);
    parallel_for(
        count, [&](std::size_t i) { visit(i, [&](Index key, Index value) { values[take_one(next[key])] = value; }); });
    parallel_for(keys, [&](std::size_t k) {
        std::sort(values.begin() + rows.begin(Index(k)), values.begin() + rows.end(Index(k)));
    });
}

/// Which edges are hard: between two facets the angle tells, and whether the surface beside the edge is smooth. A fold
/// that goes on turning beside the edge is a rounded one of few triangles, and neighbourhoods cut there would be torn.
class HardEdges {
   public:
    HardEdges(const Surface& surface, const Rows& rows, const Array<Index>& triangles, double hard_angle)
        : surface_(surface),
          rows_(rows),
          triangles_(triangles),
          least_cosine_(std::cos(glm::radians(std::min(hard_angle, 180.0)))) {}

    /// Per edge of the surface.
    Array<std::uint8_t> find() const {
        Array<std::uint8_t> hard(surface_.edges.size());
        parallel_for(hard.size(), [&](std::size_t e) { hard[e] = told(Index(e)) || folded(Index(e)); });
        drop_stray(hard);
        return hard;
    }

   private:
    static constexpr double always_hard = glm::radians(75.0), outlier = 6.0;
    static constexpr int stray_length = 3;  // edges, from each end

    /// By the artist, or because many facets meet there.
    bool told(Index edge) const {
        return surface_.edge_rows.size(edge) > 2 || (surface_.edge_rows.size(edge) == 2 && edge < surface_.mesh_edges &&
                                                     (surface_.edge_marks[edge] & mark_sharp));
    }

    bool folded(Index edge) const {
        const Index begin = surface_.edge_rows.begin(edge);
        if (surface_.edge_rows.size(edge) != 2) return false;
        const EdgeSide a = surface_.edge_sides[begin], b = surface_.edge_sides[begin + 1];
        const dvec3 first = normal(a.facet()), second = normal(b.facet());
        const double cosine = glm::dot(first, second) * (a.forward() == b.forward() ? -1.0 : 1.0);
        if (!(cosine < least_cosine_)) return false;
        const double turn = std::acos(std::max(cosine, -1.0));
        return turn > always_hard || turn > outlier * mean_turn_beside(surface_.edges[edge], first, second);
    }

    dvec3 normal(Index facet) const { return dvec3(surface_.facet_plane[facet]); }
    /// Folds of noise go on nowhere. Those that end at a border go on there.
    void drop_stray(Array<std::uint8_t>& hard) const {
        std::vector<Index> folds, borders;
        for (Index e = 0; e < hard.size(); ++e)
            if (hard[e])
                folds.push_back(e);
            else if (surface_.edge_rows.size(e) == 1)
                borders.push_back(e);
        for (int pass = 0; pass < stray_length && !folds.empty(); ++pass) {
            Array<std::uint8_t> more(surface_.vertex_count(), 0);  // 1: one of these edges ends there; 2: several
            const auto end_at = [&](Index v) { more[v] = more[v] ? 2 : 1; };
            for (const auto* ending : {&folds, &borders})
                for (const Index e : *ending) end_at(surface_.edges[e].x), end_at(surface_.edges[e].y);
            std::erase_if(folds, [&](Index e) {
                const bool stray = !told(e) && (more[surface_.edges[e].x] < 2 || more[surface_.edges[e].y] < 2);
                if (stray) hard[e] = 0;
                return stray;
            });
        }
    }

    /// Angle by which the triangles around both ends turn away from the nearer of the edge's two facets.
    double mean_turn_beside(Edge edge, const dvec3& first, const dvec3& second) const {
        double sum = 0.0;
        Index count = 0;
        for (const Index v : {edge.x, edge.y})
            for (Index i = rows_.begin(v); i < rows_.end(v); ++i, ++count) {
                const dvec3 n = normal(surface_.triangle_facet[triangles_[i]]);
                sum += std::acos(std::clamp(std::max(glm::dot(n, first), glm::dot(n, second)), -1.0, 1.0));
            }
        return count ? sum / count : 0.0;
    }

    const Surface& surface_;
    const Rows& rows_;
    const Array<Index>& triangles_;
    double least_cosine_;
};

/// Triangles around a vertex, joined over sides that are not hard; keeps the sector of the largest angle.
class Sectors {
   public:
    explicit Sectors(const Surface& surface) : surface_(surface) {}

    /// Moves the largest sector to the front of `triangles` (order kept) and returns its size.
    Index keep_largest(Index v, In<Index> hard_ends, std::span<Index> triangles) {
        const std::size_t n = triangles.size();
        sector_.resize(n);
        angle_.assign(n, 0.0);
        for (std::size_t i = 0; i < n; ++i) sector_[i] = i;
        for (bool changed = true; changed;) {  // sectors are small: pass the lowest number on until it is everywhere
            changed = false;
            for (std::size_t i = 0; i < n; ++i)
                for (std::size_t j = 0; j < i; ++j) {
                    if (sector_[i] == sector_[j] || !joined(v, triangles[i], triangles[j], hard_ends)) continue;
                    sector_[i] = sector_[j] = std::min(sector_[i], sector_[j]);
                    changed = true;
                }
        }
        for (std::size_t i = 0; i < n; ++i) angle_[sector_[i]] += corner_angle(v, triangles[i]);
        std::size_t best = 0;
        for (std::size_t i = 1; i < n; ++i)
            if (angle_[i] > angle_[best] * (1.0 + 1e-5)) best = i;
        Index kept = 0;
        for (std::size_t i = 0; i < n; ++i)
            if (sector_[i] == best) triangles[kept++] = triangles[i];
        return kept;
    }

   private:
    bool joined(Index v, Index a, Index b, In<Index> hard_ends) const {
        for (int i = 0; i < 3; ++i)
            for (int j = 0; j < 3; ++j) {
                const Index w = surface_.triangles[a][i];
                if (w == v || w != surface_.triangles[b][j]) continue;
                if (std::find(hard_ends.begin(), hard_ends.end(), w) == hard_ends.end()) return true;
            }
        return false;
    }
    double corner_angle(Index v, Index t) const {
        const Triangle& tri = surface_.triangles[t];
        const int i = tri.x == v ? 0 : tri.y == v ? 1 : 2;
        const dvec3 p(surface_.positions[v]);
        const dvec3 a = dvec3(surface_.positions[tri[(i + 1) % 3]]) - p,
                    b = dvec3(surface_.positions[tri[(i + 2) % 3]]) - p;
        return std::atan2(glm::length(glm::cross(a, b)), glm::dot(a, b));
    }

    const Surface& surface_;
    std::vector<std::size_t> sector_;
    std::vector<double> angle_;
};

Neighbours find_neighbours(const Surface& surface, double hard_angle) {
    Neighbours result;
    const Index count = surface.vertex_count();
    const auto corners = [&](std::size_t t, const auto& give) {
        for (int i = 0; i < 3; ++i) give(surface.triangles[t][i], Index(t));
    };
    sort_into_rows(count, surface.triangles.size(), corners, result.triangle_rows, result.triangles);

    // Hard edges by vertex; each vertex that has some keeps one sector.
    result.hard.assign(count, 0);
    Array<Index> kept(count);
    parallel_for(count, [&](std::size_t v) { kept[v] = result.triangle_rows.size(Index(v)); });
    if (hard_angle < no_hard_edges) {
        const Array<std::uint8_t> is_hard =
            HardEdges(surface, result.triangle_rows, result.triangles, hard_angle).find();
        const auto hard_ends = [&](std::size_t e, const auto& give) {
            if (!is_hard[e]) return;
            give(surface.edges[e].x, surface.edges[e].y);
            give(surface.edges[e].y, surface.edges[e].x);
        };
        Rows rows;
        Array<Index> ends;
        sort_into_rows(count, surface.edges.size(), hard_ends, rows, ends);
        parallel_blocks(count, 4096, [&](std::size_t, std::size_t begin, std::size_t end) {
            Sectors sectors(surface);
            for (Index v = Index(begin); v < end; ++v) {
                if (rows.size(v) == 0) continue;
                result.hard[v] = 1;
                const std::span<Index> around(result.triangles.data() + result.triangle_rows.begin(v), kept[v]);
                kept[v] = sectors.keep_largest(v, {ends.data() + rows.begin(v), rows.size(v)}, around);
            }
        });
    }
    Rows old_rows;
    Array<Index> old_triangles;
    old_rows.offsets.swap(result.triangle_rows.offsets);
    old_triangles.swap(result.triangles);
    result.triangle_rows.offsets = kept;
    counts_to_offsets(result.triangle_rows.offsets);
    result.triangles.resize(result.triangle_rows.offsets.back());
    parallel_for(count, [&](std::size_t v) {
        std::copy_n(old_triangles.begin() + old_rows.begin(Index(v)), kept[v],
                    result.triangles.begin() + result.triangle_rows.begin(Index(v)));
    });

    // Vertices of these triangles: listed twice as often as needed, then without repetitions.
    Array<Index> listed(2 * result.triangles.size());
    result.vertex_rows.offsets.resize(count);
    parallel_for(count, [&](std::size_t v) {
        const Index first = result.triangle_rows.begin(Index(v));
        auto out = listed.begin() + 2 * std::size_t(first);
        for (Index i = first; i < result.triangle_rows.end(Index(v)); ++i)
            for (int k = 0; k < 3; ++k)
                if (const Index w = surface.triangles[result.triangles[i]][k]; w != v) *out++ = w;
        const auto begin = listed.begin() + 2 * std::size_t(first);
        std::sort(begin, out);
        result.vertex_rows.offsets[v] = static_cast<Index>(std::unique(begin, out) - begin);
    });
    counts_to_offsets(result.vertex_rows.offsets);
    result.vertices.resize(result.vertex_rows.offsets.back());
    parallel_for(count, [&](std::size_t v) {
        std::copy_n(listed.begin() + 2 * std::size_t(result.triangle_rows.begin(Index(v))),
                    result.vertex_rows.size(Index(v)), result.vertices.begin() + result.vertex_rows.begin(Index(v)));
    });
    return result;
}

}  // namespace

std::shared_ptr<const Neighbours> neighbours_of(const Surface& surface, double hard_angle) {
    return surface.cache().get<Neighbours>(hash_numbers(std::bit_cast<std::uint64_t>(hard_angle)),
                                           [&] { return find_neighbours(surface, hard_angle); });
}

}  // namespace fovea
