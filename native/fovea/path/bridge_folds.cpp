// SPDX-License-Identifier: GPL-3.0-or-later
#include <fovea/path/bridge_folds.h>

#include <glm/gtc/constants.hpp>
#include <limits>

#include <fovea/base/parallel.h>
#include <fovea/line/edges.h>
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

/// Appends the edges of the folds of one chain, those of `all` with the numbers `chain`. `is_line`: per edge of `all`.
void bridge(const SurfaceView& seen, const Array<Index>& all, In<Index> chain, bool closed, In<std::uint8_t> is_line,
            Array<Index>& folds) {
    const std::size_t count = chain.size();
    const auto has = [&](std::size_t i) { return is_line[chain[i % count]] != 0; };
    const auto edge = [&](std::size_t i) { return all[chain[i % count]]; };
    std::size_t first = 0;
    while (first < count && !has(first)) ++first;
    if (first == count) return;
    // From a line's edge to the next one; around a closed chain, until the first one is reached again.
    const std::size_t end = closed ? first + count : count - 1;
    for (std::size_t i = first; i < end;) {
        std::size_t next = i + 1;
        double length = 0.0;
        while (next <= end && !has(next)) length += length_in_image(seen, edge(next++));
        if (next <= end && length <= longest)
            for (std::size_t k = i + 1; k < next; ++k) folds.push_back(edge(k));
        i = next;
    }
}

}  // namespace

Array<Index> bridge_folds(const SurfaceView& seen, const LineDefinition& whole, const Array<Index>& edges) {
    const Array<Index> all = either(std::get<EdgeRule>(whole.rule).find(seen, default_values(whole)), edges);
    Array<std::uint8_t> is_line(all.size(), 0);
    for (std::size_t i = 0, k = 0; k < edges.size(); ++i)
        if (all[i] == edges[k]) is_line[i] = 1, ++k;
    const Array<std::uint8_t> labels(all.size(), 0);
    const Chains chains = chain(seen, true, all, labels, Array<double>{glm::pi<double>()});
    auto folds = parallel_collect<Index>(chains.rows.count(), 16, [&](std::size_t begin, std::size_t end, auto& found) {
        for (auto c = static_cast<Index>(begin); c < end; ++c)
            bridge(seen, all, In<Index>(chains.number).subspan(chains.rows.begin(c), chains.rows.size(c) - 1),
                   chains.closed[c], is_line, found);
    });
    parallel_sort(folds.begin(), folds.end());
    return either(edges, folds);
}

}  // namespace fovea::path
