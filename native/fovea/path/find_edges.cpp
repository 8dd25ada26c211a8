// SPDX-License-Identifier: GPL-3.0-or-later
#include <fovea/path/find_edges.h>

#include <algorithm>
#include <glm/gtc/constants.hpp>

#include <fovea/base/hash.h>
#include <fovea/base/parallel.h>
#include <fovea/line/look_at.h>
#include <fovea/path/bridge_folds.h>
#include <fovea/path/doubles.h>
#include <fovea/path/paths.h>

namespace fovea::path {
namespace {

constexpr std::uint8_t unlabelled = 255;

void trace_kinds(const PlacedSet& set, const SurfaceView& seen, bool of_surface, Array<Kinds>& kinds) {
    for (const LineKind& kind : set.kinds) {
        const LineDefinition& definition = *line_definitions()[kind.definition];
        const auto* edges = std::get_if<EdgeRule>(&definition.rule);
        const Kinds bit = Kinds(1) << kind.definition;
        if (!edges || (definition.scope == Scope::surface) != of_surface) continue;
        edges->mark(seen, kind.values, bit, kinds);
        if (edges->part_of) bridge_folds(seen, *edges->part_of, bit, kinds);
    }
    if (set.materials.empty()) return;
    const auto wanted = [&](int material) { return set.has_material(material); };
    parallel_for(kinds.size(), [&](std::size_t e) {
        if (kinds[e] && !any_beside(seen.surface, static_cast<Index>(e), wanted)) kinds[e] = 0;
    });
}

/// Per edge: mesh-edge contours whose smooth twin is requested on an adjacent face.
Array<Kinds> doubled_at_edges(const Surface& surface, const std::vector<PlacedSet>& sets) {
    const bool by_material = any_by_material(sets);
    auto doubled = parallel_filled(surface.edges.size(), by_material ? Kinds(0) : doubled_edges(asked_of(sets)));
    if (!by_material) return doubled;
    for (const PlacedSet& set : sets)
        if (const Kinds of_set = doubled_edges(asked_of(set)))
            parallel_for(doubled.size(), [&](std::size_t e) {
                const auto has = [&](int material) { return set.has_material(material); };
                if (any_beside(surface, static_cast<Index>(e), has)) doubled[e] |= of_set;
            });
    return doubled;
}

StaticLines find_static(const Surface& surface, const std::vector<PlacedSet>& sets) {
    StaticLines lines;
    const SurfaceView seen{.surface = surface};
    auto any = parallel_filled(surface.edges.size(), std::uint8_t(0));
    for (const PlacedSet& set : sets) {
        Array<Kinds>& kinds = lines.kinds.emplace_back(parallel_filled(surface.edges.size(), Kinds(0)));
        trace_kinds(set, seen, true, kinds);
        parallel_for(kinds.size(), [&](std::size_t e) { any[e] |= kinds[e] != 0; });
    }
    for (Index e = 0; e < any.size(); ++e)
        if (any[e]) lines.edges.push_back(e);
    return lines;
}

/// Edges labeled with the first line set that has them: the edges of StaticLines, in their order, and the others.
struct Labelled {
    Array<std::uint8_t> kept_labels, seen_labels;
    Array<Index> seen_edges;
    Array<Kinds> kinds;  // per edge, of the set that has it
};

Labelled label_edges(const StaticLines& lines, const std::vector<Array<Kinds>>& kinds) {
    Labelled labelled;
    const std::size_t edges = kinds[0].size();
    auto label = parallel_filled(edges, unlabelled);
    labelled.kinds.resize(edges);
    parallel_for(edges, [&](std::size_t e) {
        labelled.kinds[e] = 0;
        for (std::size_t s = kinds.size(); s-- > 0;)
            if (kinds[s][e]) {
                label[e] = static_cast<std::uint8_t>(s);
                labelled.kinds[e] = kinds[s][e];
            }
    });
    const auto kept_label = [&](std::size_t i) { return label[lines.edges[i]]; };
    labelled.kept_labels = parallel_map<std::uint8_t>(lines.edges.size(), kept_label);
    std::size_t next = 0;
    for (Index e = 0; e < edges; ++e) {
        if (next < lines.edges.size() && lines.edges[next] == e) {
            ++next;
        } else if (label[e] != unlabelled) {
            labelled.seen_edges.push_back(e);
            labelled.seen_labels.push_back(label[e]);
        }
    }
    return labelled;
}

Array<Kinds> kinds_of(const Chains& chains, const Array<Kinds>& edge_kinds) {
    return parallel_map<Kinds>(chains.edge.size(), [&](std::size_t i) { return edge_kinds[chains.edge[i]]; });
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

Kinds doubled_edges(Kinds asked) {
    Kinds doubled = 0;
    for (const LineDefinition* definition : line_definitions())
        if (definition->smooth_twin && (asked & kind_of(*definition->smooth_twin))) doubled |= kind_of(*definition);
    return doubled;
}

FoundEdges find_edges(SurfaceView seen, const std::vector<PlacedSet>& sets, std::uint64_t sets_hash, bool of_view) {
    const Surface& surface = seen.surface;
    FoundEdges found;
    found.kept = surface.cache().get<StaticLines>(sets_hash, [&] { return find_static(surface, sets); });
    for (const Array<Kinds>& kinds : found.kept->kinds) found.kinds.push_back(parallel_copy(kinds));
    if (!of_view) return found;
    seen.facing = facing_of(seen, edge_on_to_viewer);
    const Kinds doubled = doubled_edges(asked_of(sets));
    if (doubled) found.doubled = doubled_at_edges(surface, sets);
    auto all = parallel_filled(found.doubled.size(), Kinds(0));
    for (std::size_t s = 0; s < sets.size(); ++s) {
        trace_kinds(sets[s], seen, false, found.kinds[s]);
        parallel_for(all.size(), [&](std::size_t e) { all[e] |= found.kinds[s][e]; });
    }
    if (doubled) found.hard = at_hard_edges(surface, doubled, all);
    return found;
}

EdgePaths chain_edges(const SurfaceView& seen, const std::vector<PlacedSet>& sets, std::uint64_t sets_hash,
                      FoundEdges found, In<std::uint8_t> near) {
    const Surface& surface = seen.surface;
    if (!found.doubled.empty() && !near.empty())
        for (Array<Kinds>& kinds : found.kinds) drop_doubled_edges(surface, near, found.doubled, kinds);
    // Near cusps, contours of a mesh fold back on themselves. They are chained into one path through all folds (no
    // corner angle), so that later stages can tell visible fragments of folds from lines.
    std::vector<double> corner_angles, never(sets.size(), glm::pi<double>());
    for (const PlacedSet& set : sets) corner_angles.push_back(set.corner_angle_rad);
    const Labelled labelled = label_edges(*found.kept, found.kinds);
    // With a single line set the labels never change, so the view-independent chains are built once.
    const std::uint64_t chains_hash = hash_of(In<std::uint8_t>(labelled.kept_labels), sets_hash);
    const auto kept_chains = surface.cache().get<Chains>(
        chains_hash, [&] { return chain(seen, false, found.kept->edges, labelled.kept_labels, corner_angles); });
    const auto seen_chains =
        std::make_shared<const Chains>(chain(seen, true, labelled.seen_edges, labelled.seen_labels, never));
    const Array<std::uint8_t> lines_at = lines_at_vertices(surface, found.kept->edges, labelled.seen_edges);
    const auto with_kinds = [&](const std::shared_ptr<const Chains>& chains) -> EdgeChains {
        return {chains, kinds_of(*chains, labelled.kinds), free_ends(*chains, lines_at)};
    };
    return {with_kinds(kept_chains), with_kinds(seen_chains)};
}

}  // namespace fovea::path
