// SPDX-License-Identifier: GPL-3.0-or-later
// Lists of edges, shared by definitions on mesh edges.
#pragma once

#include <algorithm>
#include <iterator>

#include <fovea/base/parallel.h>
#include <fovea/line/definition.h>

namespace fovea::line {

/// The edges [0, count) for which `is_line(edge)` holds, ascending. It is called by several threads.
template <typename IsLine>
Array<Index> edges_where(std::size_t count, const IsLine& is_line) {
    return parallel_collect<Index>(count, 1 << 14, [&](std::size_t begin, std::size_t end, Array<Index>& edges) {
        for (auto e = static_cast<Index>(begin); e < end; ++e)
            if (is_line(e)) edges.push_back(e);
    });
}

/// The edges that are in at least one of two ascending lists; ascending, each once.
inline Array<Index> either(const Array<Index>& first, const Array<Index>& second) {
    Array<Index> edges;
    edges.reserve(first.size() + second.size());
    std::ranges::set_union(first, second, std::back_inserter(edges));
    return edges;
}

}  // namespace fovea::line
