// SPDX-License-Identifier: GPL-3.0-or-later
#include <fovea/path/bridge_folds.h>

#include <glm/gtc/constants.hpp>
#include <limits>

#include <fovea/base/parallel.h>
#include <fovea/path/chain.h>

namespace fovea::path {
namespace {

constexpr double longest = 30.0;  // reference pixels of a fold

/// Length of an edge in the image [reference px]; infinite if an end is behind the eye.
double length_in_image(const SurfaceView& seen, Index edge) {
    const View& view = seen.tracer->view();
    const auto in_clip = [&](Index vertex) {
        return view.view_to_clip * (seen.object_to_view * dvec4(dvec3(seen.surface.positions[vertex]), 1.0));
    };
    const dvec4 a = in_clip(seen.surface.edges[edge].x), b = in_clip(seen.surface.edges[edge].y);
    if (a.w <= 0.0 || b.w <= 0.0) return std::numeric_limits<double>::infinity();
    return glm::distance(to_pixels(view, a), to_pixels(view, b)) / view.reference_scale;
}

/// Bridges the folds of one chain of edges.
void bridge(const SurfaceView& seen, In<Index> edges, bool closed, Kinds bit, Array<Kinds>& kinds) {
    const std::size_t count = edges.size();
    const auto has = [&](std::size_t i) { return (kinds[edges[i % count]] & bit) != 0; };
    std::size_t first = 0;
    while (first < count && !has(first)) ++first;
    if (first == count) return;
    // From an edge that has the bit to the next one; around a closed chain, until the first one is reached again.
    const std::size_t end = closed ? first + count : count - 1;
    for (std::size_t i = first; i < end;) {
        std::size_t next = i + 1;
        double length = 0.0;
        while (next <= end && !has(next)) length += length_in_image(seen, edges[next++ % count]);
        if (next <= end && length <= longest)
            for (std::size_t k = i + 1; k < next; ++k) kinds[edges[k % count]] |= bit;
        i = next;
    }
}

}  // namespace

void bridge_folds(const SurfaceView& seen, const LineDefinition& whole, Kinds bit, Array<Kinds>& kinds) {
    auto candidates = parallel_filled(kinds.size(), Kinds(0));
    std::get<EdgeRule>(whole.rule).mark(seen, default_values(whole), 1, candidates);
    Array<Index> edges;
    for (Index e = 0; e < candidates.size(); ++e)
        if (candidates[e] || (kinds[e] & bit)) edges.push_back(e);
    const Array<std::uint8_t> labels(edges.size(), 0);
    const Chains chains = chain(seen, true, edges, labels, Array<double>{glm::pi<double>()});
    parallel_for(chains.rows.count(), 16, [&](std::size_t c) {
        const In<Index> of_chain(chains.edge.data() + chains.rows.begin(Index(c)), chains.rows.size(Index(c)) - 1);
        bridge(seen, of_chain, chains.closed[c], bit, kinds);
    });
}

}  // namespace fovea::path
