// SPDX-License-Identifier: GPL-3.0-or-later
#include <fovea/path/find_edges.h>

#include <algorithm>
#include <glm/gtc/constants.hpp>
#include <utility>

#include <fovea/base/hash.h>
#include <fovea/base/parallel.h>
#include <fovea/line/look_at.h>
#include <fovea/path/doubles.h>
#include <fovea/path/paths.h>

namespace fovea::path {
namespace {

/// Definitions on mesh edges whose smooth twin is in `asked`.
Kinds doubled_edges(Kinds asked) {
    Kinds doubled = 0;
    for (const LineDefinition* definition : line_definitions())
        if (definition->smooth_twin && (asked & kind_of(*definition->smooth_twin))) doubled |= kind_of(*definition);
    return doubled;
}

StaticLines find_static(const Surface& surface, const std::vector<PlacedSet>& sets) {
    StaticLines lines;
    const SurfaceView seen{.surface = surface};
    for (const PlacedSet& set : sets)
        lines.of_sets.push_back(mark_edges(set, static_cast<std::uint8_t>(lines.of_sets.size()), seen, true));
    const MarkedEdges any = of_first_sets(surface.edges.size(), lines.of_sets);
    lines.edges = parallel_map<Index>(any.size(), [&](std::size_t i) { return any[i].edge; });
    return lines;
}

/// Edges that are chained, and the first line set that has them as their label.
struct Labelled {
    Array<Index> edges;
    Array<std::uint8_t> labels;
    Array<Kinds> kinds;  // of that set

    explicit Labelled(std::size_t count) {
        edges.reserve(count);
        labels.reserve(count);
        kinds.reserve(count);
    }
    void add(const MarkedEdge& marked) {
        edges.push_back(marked.edge);
        labels.push_back(marked.set);
        kinds.push_back(marked.kinds);
    }
};

/// The marked edges: those of `kept`, all of which are among them, and the others.
std::pair<Labelled, Labelled> label_edges(In<Index> kept, const MarkedEdges& marked) {
    Labelled of_kept(kept.size()), others(marked.size() - kept.size());
    for (const MarkedEdge& of : marked) {
        const std::size_t next = of_kept.edges.size();
        (next < kept.size() && kept[next] == of.edge ? of_kept : others).add(of);
    }
    return {std::move(of_kept), std::move(others)};
}

/// Drops mesh-edge contours beside a smooth one, where that is requested on a face at the edge.
void drop_doubled(const Surface& surface, const std::vector<PlacedSet>& sets, In<std::uint8_t> near,
                  std::vector<MarkedEdges>& of_sets) {
    std::vector<Kinds> doubled;
    for (const PlacedSet& set : sets) doubled.push_back(doubled_edges(asked_of(set)));
    const auto doubled_at = [&](Index edge) {
        Kinds all = 0;
        for (std::size_t s = 0; s < sets.size(); ++s) {
            const auto has = [&](int material) { return sets[s].has_material(material); };
            if (doubled[s] && any_beside(surface, edge, has)) all |= doubled[s];
        }
        return all;
    };
    for (MarkedEdges& marked : of_sets) marked = without_doubled(marked, surface, near, doubled_at);
}

Array<Kinds> kinds_of(const Chains& chains, const Labelled& of) {
    return parallel_map<Kinds>(chains.number.size(), [&](std::size_t i) { return of.kinds[chains.number[i]]; });
}

/// Number of lines at each vertex, capped at 2.
Array<std::uint8_t> lines_at_vertices(const Surface& surface, In<Index> kept, In<Index> seen) {
    auto count = parallel_filled(std::size_t(surface.vertex_count()), std::uint8_t(0));
    for (const In<Index> edges : {kept, seen})
        for (Index e : edges)
            for (Index v : {surface.edges[e].x, surface.edges[e].y}) count[v] = std::min(count[v] + 1, 2);
    return count;
}

Array<std::uint8_t> free_ends(const Chains& chains, const Array<std::uint8_t>& lines_at) {
    return parallel_map<std::uint8_t>(chains.rows.count(), [&](std::size_t c) {
        const Index first = chains.vertex[chains.rows.begin(c)], last = chains.vertex[chains.rows.end(c) - 1];
        return (lines_at[first] < 2 ? free_start : 0) | (lines_at[last] < 2 ? free_end : 0);
    });
}

}  // namespace

FoundEdges find_edges(SurfaceView seen, const std::vector<PlacedSet>& sets, std::uint64_t sets_hash, bool of_view) {
    const Surface& surface = seen.surface;
    FoundEdges found;
    found.kept = surface.cache().get<StaticLines>(sets_hash, [&] { return find_static(surface, sets); });
    if (!of_view) {
        for (const MarkedEdges& marked : found.kept->of_sets) found.of_sets.push_back(parallel_copy(marked));
        return found;
    }
    seen.facing = facing_of(seen, edge_on_to_viewer);
    for (std::size_t s = 0; s < sets.size(); ++s)
        found.of_sets.push_back(mark_edges(sets[s], static_cast<std::uint8_t>(s), seen, false, found.kept->of_sets[s]));
    found.doubled = doubled_edges(asked_of(sets));
    if (found.doubled) found.hard = at_hard_edges(surface, found.doubled, found.of_sets);
    return found;
}

EdgePaths chain_edges(const SurfaceView& seen, const std::vector<PlacedSet>& sets, std::uint64_t sets_hash,
                      FoundEdges found, In<std::uint8_t> near) {
    const Surface& surface = seen.surface;
    if (found.doubled && !near.empty()) drop_doubled(surface, sets, near, found.of_sets);
    // Near cusps, contours of a mesh fold back on themselves. They are chained into one path through all folds (no
    // corner angle), so that later stages can tell visible fragments of folds from lines.
    std::vector<double> corner_angles, never(sets.size(), glm::pi<double>());
    for (const PlacedSet& set : sets) corner_angles.push_back(set.corner_angle_rad);
    const auto [kept, others] = label_edges(found.kept->edges, of_first_sets(surface.edges.size(), found.of_sets));
    // With a single line set the labels never change, so the view-independent chains are built once.
    const std::uint64_t chains_hash = hash_of(In<std::uint8_t>(kept.labels), sets_hash);
    const auto kept_chains = surface.cache().get<Chains>(
        chains_hash, [&, &kept = kept] { return chain(seen, false, kept.edges, kept.labels, corner_angles); });
    const auto seen_chains = std::make_shared<const Chains>(chain(seen, true, others.edges, others.labels, never));
    const Array<std::uint8_t> lines_at = lines_at_vertices(surface, kept.edges, others.edges);
    const auto with_kinds = [&](const std::shared_ptr<const Chains>& chains, const Labelled& of) -> EdgeChains {
        return {chains, kinds_of(*chains, of), free_ends(*chains, lines_at)};
    };
    return {with_kinds(kept_chains, kept), with_kinds(seen_chains, others)};
}

}  // namespace fovea::path
