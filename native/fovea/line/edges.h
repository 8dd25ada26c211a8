// SPDX-License-Identifier: GPL-3.0-or-later
// Lists of edges put together.
#pragma once

#include <algorithm>
#include <iterator>

#include <fovea/base/types.h>

namespace fovea::line {

/// The edges that are in at least one of two ascending lists; ascending, each once.
inline Array<Index> either(const Array<Index>& first, const Array<Index>& second) {
    Array<Index> edges;
    edges.reserve(first.size() + second.size());
    std::ranges::set_union(first, second, std::back_inserter(edges));
    return edges;
}

}  // namespace fovea::line
