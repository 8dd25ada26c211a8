// SPDX-License-Identifier: GPL-3.0-or-later
// Traversal of chains of linked elements.
#pragma once

#include <fovea/base/types.h>

namespace fovea::path {

/// Traverses chains of elements; element k has the ends 2 k and 2 k + 1. next[end]: the end of another element that it
/// is linked to (symmetric), or `none`. Per chain, calls point(end) at the start of each element and at the end of the
/// last one, then finish(closed). Open chains come first, each from its lower free end; the rest are loops.
template <typename Point, typename Finish>
void walk_ends(In<Index> next, const Point& point, const Finish& finish) {
    std::vector<std::uint8_t> taken(next.size() / 2, 0);
    const auto walk = [&](Index start) {
        Index end = start, on = start;
        do {
            end = on;
            taken[end / 2] = 1;
            point(end);
            on = next[end ^ 1];
        } while (on != none && on != start);
        point(end ^ 1);
        finish(on == start);
    };
    for (Index end = 0; end < next.size(); ++end)
        if (next[end] == none && !taken[end / 2]) walk(end);
    for (Index k = 0; k < taken.size(); ++k)
        if (!taken[k]) walk(2 * k);
}

}  // namespace fovea::path
