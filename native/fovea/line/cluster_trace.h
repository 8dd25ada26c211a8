// SPDX-License-Identifier: GPL-3.0-or-later
// Zero sets as in zero_set.h, but cluster by cluster with culling, so that the cost follows the lines, not the surface.
// A definition provides:
//
//   none_in(SeenCluster)    true only if a cluster certainly has no line: it is skipped
//   eval(vertex)            quantities that decide which triangles can have a line; once per vertex and cluster left
//   wanted(a, b, c)         of the evals at a triangle's corners: false skips the triangle
//   detail(vertex, eval)    further quantities, evaluated only at corners of triangles that are left
#pragma once

#include <algorithm>

#include <fovea/base/parallel.h>
#include <fovea/line/seen_cluster.h>
#include <fovea/line/seen_vertices.h>
#include <fovea/line/zero_set.h>

namespace fovea::line {

/// Concatenates pieces in ascending order of their triangles; pieces of the same triangle keep their order.
Curves in_order_of_triangles(const std::vector<Array<CurvePiece>>& parts, std::size_t triangles);

/// Indices of the clusters for which none_in is false, ascending.
template <typename NoneIn>
Array<Index> clusters_with_lines(const SurfaceView& seen, const Hierarchy& hierarchy, const NoneIn& none_in) {
    Array<Index> kept;
    const auto passed_over = [&](const ClusterBounds& b) { return seen.pass_over && none_in(SeenCluster(seen, b)); };
    const Index count = static_cast<Index>(hierarchy.clusters.size());
    for (Index g = 0; g < hierarchy.groups.size(); ++g) {
        if (passed_over(hierarchy.groups[g])) continue;
        for (Index c = g * Hierarchy::group; c < std::min((g + 1) * Hierarchy::group, count); ++c)
            if (!passed_over(hierarchy.clusters[c])) kept.push_back(c);
    }
    return kept;
}

/// Prefetches what the evaluation of these vertices reads; a cluster's vertices are scattered in memory.
inline void fetch_vertices(const Surface& surface, const Fields& fields, In<Index> vertices) {
    for (Index v : vertices) {
        const auto* curvature = reinterpret_cast<const char*>(&fields.curvature[v]);
        __builtin_prefetch(&surface.positions[v]);
        __builtin_prefetch(curvature);
        __builtin_prefetch(curvature + sizeof(Curvature) - 1);
    }
}

/// Scratch space for one cluster.
template <typename VertexEval, typename Detail>
struct Looks {
    VertexEval evals[3 * triangles_of_cluster];
    Detail details[3 * triangles_of_cluster];
    bool matters[3 * triangles_of_cluster];  // per vertex: is a corner of a triangle that is left
    Index entries[triangles_of_cluster];     // triangles that are left, as indices into Clusters::triangles
};

/// Calls emit(triangle, eval_at, detail_at, out) for the triangles that are left; eval_at and detail_at take a vertex
/// of the triangle.
template <typename NoneIn, typename EvalAt, typename Wanted, typename DetailAt, typename Emit>
static Curves trace_clusters(const SurfaceView& seen, const NoneIn& none_in, const EvalAt& eval, const Wanted& wanted,
                             const DetailAt& detail, const Emit& emit) {
    using VertexEval = decltype(eval(Index()));
    using Detail = decltype(detail(Index(), VertexEval()));
    const Surface& surface = seen.surface;
    const auto fields = fields_of(surface);
    const auto clusters = clusters_of(surface);
    const Array<Index> with_lines = clusters_with_lines(seen, *hierarchy_of(surface), none_in);
    constexpr std::size_t block = 32;
    const auto trace = [&](Array<CurvePiece>& part, std::size_t begin, std::size_t end) {
        Looks<VertexEval, Detail> looks;
        for (std::size_t k = begin; k < end; ++k) {
            if (k + 1 < end) fetch_vertices(surface, *fields, clusters->vertices[with_lines[k + 1]]);
            const In<Index> vertices = clusters->vertices[with_lines[k]];
            for (std::size_t i = 0; i < vertices.size(); ++i) looks.evals[i] = eval(vertices[i]);
            std::fill_n(looks.matters, vertices.size(), false);
            Index count = 0;
            for (Index i = clusters->begin(with_lines[k]); i < clusters->end(with_lines[k]); ++i) {
                const glm::u16vec3 c = clusters->corners[i];
                if (!wanted(looks.evals[c.x], looks.evals[c.y], looks.evals[c.z])) continue;
                looks.matters[c.x] = looks.matters[c.y] = looks.matters[c.z] = true;
                looks.entries[count++] = i;
            }
            if (count == 0) continue;
            for (std::size_t i = 0; i < vertices.size(); ++i)
                if (looks.matters[i]) looks.details[i] = detail(vertices[i], looks.evals[i]);
            for (Index n = 0; n < count; ++n) {
                const Index triangle = clusters->triangles[looks.entries[n]];
                const glm::u16vec3 c = clusters->corners[looks.entries[n]];
                const Triangle& t = surface.triangles[triangle];
                const auto place = [&](Index v) { return v == t.x ? c.x : v == t.y ? c.y : c.z; };
                emit(
                    triangle, [&](Index v) -> const VertexEval& { return looks.evals[place(v)]; },
                    [&](Index v) -> const Detail& { return looks.details[place(v)]; }, part);
            }
        }
    };
    const auto parts = parallel_parts<Array<CurvePiece>>(with_lines.size(), block, trace);
    return in_order_of_triangles(parts, surface.triangles.size());
}

/// As trace_zero_set of zero_set.h, with culling. An eval has a member `value`; a detail is the margin.
template <typename NoneIn, typename EvalAt, typename Wanted, typename Margin, typename Strength>
static Curves trace_zero_set(const SurfaceView& seen, const NoneIn& none_in, const EvalAt& eval, const Wanted& wanted,
                             const Margin& margin, const Strength& strength) {
    const auto sides = triangle_sides(seen.surface);
    const auto crossed = [&](const auto& a, const auto& b, const auto& c) {
        const bool positive = a.value >= 0.0f;
        return (positive != (b.value >= 0.0f) || positive != (c.value >= 0.0f)) && wanted(a, b, c);
    };
    return trace_clusters(seen, none_in, eval, crossed, margin,
                          [&](Index triangle, const auto& eval_at, const auto& margin_at, auto& out) {
                              append_zero(
                                  seen.surface, *sides, triangle, [&](Index v) { return eval_at(v).value; }, margin_at,
                                  strength, out);
                          });
}

/// Zero set of value(curvature, SeenOf), restricted to front-facing parts (n . v > 0) where margin(curvature, SeenOf)
/// is positive.
template <typename NoneIn, typename Value, typename Margin, typename Strength>
static Curves trace_zero_set_in_front(const SurfaceView& seen, const NoneIn& none_in, const Value& value,
                                      const Margin& margin, const Strength& strength) {
    const auto fields = fields_of(seen.surface);
    struct VertexEval {
        float value;
        SeenOf<float> seen;
    };
    const auto eval = [&](Index v) -> VertexEval {
        const SeenOf<float> s = see_vertex(seen, fields->curvature[v], v);
        return {value(fields->curvature[v], s), s};
    };
    const auto margins_at = [&](Index v, const VertexEval& at) {
        return vec2(margin(fields->curvature[v], at.seen), at.seen.facing);
    };
    const auto front = [](const VertexEval& a, const VertexEval& b, const VertexEval& c) {
        return a.seen.facing > 0.0f || b.seen.facing > 0.0f || c.seen.facing > 0.0f;
    };
    return trace_zero_set(seen, none_in, eval, front, margins_at, strength);
}

/// Level sets of value(vertex): separate pieces for each of `levels`.
template <typename NoneIn, typename Value>
static Curves trace_levels(const SurfaceView& seen, const NoneIn& none_in, const Value& value, const Levels& levels) {
    struct VertexEval {
        float value;
        int below;
    };
    const auto sides = triangle_sides(seen.surface);
    const auto eval = [&](Index v) -> VertexEval {
        const float here = value(v);
        return {here, levels.below(here)};
    };
    const auto crossed = [](const VertexEval& a, const VertexEval& b, const VertexEval& c) {
        return a.below != b.below || a.below != c.below;
    };
    const auto nothing = [](Index, const VertexEval&) { return true; };
    return trace_clusters(
        seen, none_in, eval, crossed, nothing, [&](Index triangle, const auto& eval_at, const auto&, auto& out) {
            append_levels(seen.surface, *sides, triangle, [&](Index v) { return eval_at(v).value; }, levels, out);
        });
}

}  // namespace fovea::line
