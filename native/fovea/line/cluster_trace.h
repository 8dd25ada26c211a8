// SPDX-License-Identifier: GPL-3.0-or-later
// Zero sets as in zero_set.h, cluster by cluster: the work follows the lines, not the surface.
//
//   none_in(SeenCluster)    true only where it is certain that a cluster has no line: it is passed over
//   eval(vertex)            what decides which triangles matter, once per vertex of the clusters that are left
//   wanted(a, b, c)         of eval at the corners of a triangle: false passes it over
//   detail(vertex, eval)    the rest of what is to be known, at the corners of triangles that matter
#pragma once

#include <algorithm>

#include <fovea/base/parallel.h>
#include <fovea/line/seen_cluster.h>
#include <fovea/line/seen_vertices.h>
#include <fovea/line/zero_set.h>

namespace fovea::line {

/// Pieces in the order of their triangles; those of one triangle keep theirs.
Curves in_order_of_triangles(const std::vector<std::vector<CurvePiece>>& parts, std::size_t triangles);

/// Numbers of the clusters for which none_in is false, ascending.
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

/// Fetches what the evaluation of a vertex reads, ahead of time: vertices of a cluster are spread over memory.
inline void fetch_vertices(const Surface& surface, const Fields& fields, In<Index> vertices) {
    for (Index v : vertices) {
        const auto* curvature = reinterpret_cast<const char*>(&fields.curvature[v]);
        __builtin_prefetch(&surface.positions[v]);
        __builtin_prefetch(curvature);
        __builtin_prefetch(curvature + sizeof(Curvature) - 1);
    }
}

/// What is known of one cluster.
template <typename VertexEval, typename Detail>
struct Looks {
    VertexEval evals[3 * triangles_of_cluster];
    Detail details[3 * triangles_of_cluster];
    bool matters[3 * triangles_of_cluster];  // per vertex: has details
    Index entries[triangles_of_cluster];     // triangles that matter, as entries of Clusters::triangles
};

/// Runs emit(triangle, eval_at, detail_at, out), with functions of the triangle's vertices, where lines may be.
template <typename NoneIn, typename EvalAt, typename Wanted, typename DetailAt, typename Emit>
Curves trace_clusters(const SurfaceView& seen, const NoneIn& none_in, const EvalAt& eval, const Wanted& wanted,
                      const DetailAt& detail, const Emit& emit) {
    using VertexEval = decltype(eval(Index()));
    using Detail = decltype(detail(Index(), VertexEval()));
    const Surface& surface = seen.surface;
    const auto fields = fields_of(surface);
    const auto clusters = clusters_of(surface);
    const Array<Index> with_lines = clusters_with_lines(seen, *hierarchy_of(surface), none_in);
    constexpr std::size_t block = 32;
    std::vector<std::vector<CurvePiece>> parts((with_lines.size() + block - 1) / block);
    parallel_blocks(with_lines.size(), block, [&](std::size_t b, std::size_t begin, std::size_t end) {
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
                    [&](Index v) -> const Detail& { return looks.details[place(v)]; }, parts[b]);
            }
        }
    });
    return in_order_of_triangles(parts, surface.triangles.size());
}

/// trace_zero_set; an eval has `value`, and a detail is the margin.
template <typename NoneIn, typename EvalAt, typename Wanted, typename Margin, typename Strength>
Curves trace_zero_set(const SurfaceView& seen, const NoneIn& none_in, const EvalAt& eval, const Wanted& wanted,
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

/// trace_zero_set of value(curvature, seen vertex) on the side that faces the viewer, where margin(curvature, seen
/// vertex) is positive.
template <typename NoneIn, typename Value, typename Margin, typename Strength>
Curves trace_zero_set_in_front(const SurfaceView& seen, const NoneIn& none_in, const Value& value, const Margin& margin,
                               const Strength& strength) {
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

/// Curves where value(vertex) is one of the levels: pieces of its own for each.
template <typename NoneIn, typename Value>
Curves trace_levels(const SurfaceView& seen, const NoneIn& none_in, const Value& value, const Levels& levels) {
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
