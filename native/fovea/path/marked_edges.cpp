// SPDX-License-Identifier: GPL-3.0-or-later
#include <fovea/path/marked_edges.h>

#include <algorithm>

#include <fovea/base/parallel.h>
#include <fovea/path/bridge_folds.h>

namespace fovea::path {
namespace {

/// The edges of several lists, of numbers below `edges`. add(first, other): what to do where two lists have an edge.
template <typename Add>
MarkedEdges merge(std::size_t edges, const std::vector<In<MarkedEdge>>& lists, const Add& add) {
    return parallel_collect<MarkedEdge>(edges, 1 << 14, [&](std::size_t begin, std::size_t end, MarkedEdges& merged) {
        std::vector<In<MarkedEdge>> rest;
        for (const In<MarkedEdge> list : lists) {
            const auto at = [&](std::size_t edge) {
                return std::ranges::lower_bound(list, static_cast<Index>(edge), {}, &MarkedEdge::edge);
            };
            rest.emplace_back(at(begin), at(end));
        }
        for (;;) {
            Index next = none;
            for (const In<MarkedEdge>& list : rest)
                if (!list.empty()) next = std::min(next, list[0].edge);
            if (next == none) return;
            bool is_first = true;
            for (In<MarkedEdge>& list : rest) {
                if (list.empty() || list[0].edge != next) continue;
                if (is_first)
                    merged.push_back(list[0]);
                else
                    add(merged.back(), list[0]);
                is_first = false;
                list = list.subspan(1);
            }
        }
    });
}

}  // namespace

MarkedEdges mark_edges(const PlacedSet& set, std::uint8_t number, const SurfaceView& seen, bool of_surface,
                       const MarkedEdges& kept) {
    const Surface& surface = seen.surface;
    std::vector<MarkedEdges> found;
    for (const LineKind& kind : set.kinds) {
        const LineDefinition& definition = *line_definitions()[kind.definition];
        const auto* rule = std::get_if<EdgeRule>(&definition.rule);
        if (!rule || (definition.scope == Scope::surface) != of_surface) continue;
        Array<Index> edges = rule->find(seen, kind.values);
        if (rule->part_of) edges = bridge_folds(seen, *rule->part_of, edges);
        found.push_back(parallel_map<MarkedEdge>(edges.size(), [&](std::size_t i) -> MarkedEdge {
            return {edges[i], Kinds(1) << kind.definition, number};
        }));
    }
    if (found.empty()) return parallel_copy(kept);
    std::vector<In<MarkedEdge>> lists{kept};
    lists.insert(lists.end(), found.begin(), found.end());
    const auto add_kinds = [](MarkedEdge& first, const MarkedEdge& other) { first.kinds |= other.kinds; };
    MarkedEdges marked = merge(surface.edges.size(), lists, add_kinds);
    if (set.materials.empty()) return marked;
    const auto wanted = [&](int material) { return set.has_material(material); };
    return parallel_filter(marked, 4096, [&](const MarkedEdge& of) { return any_beside(surface, of.edge, wanted); });
}

MarkedEdges of_first_sets(std::size_t edges, const std::vector<MarkedEdges>& of_sets) {
    return merge(edges, {of_sets.begin(), of_sets.end()}, [](MarkedEdge&, const MarkedEdge&) {});
}

}  // namespace fovea::path
