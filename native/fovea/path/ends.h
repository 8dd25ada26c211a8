// SPDX-License-Identifier: GPL-3.0-or-later
// Elements linked end to end, one after the other.
#pragma once

#include <fovea/base/types.h>

namespace fovea::path {

/// Goes along chains of elements, of which element k has the ends 2 k and 2 k + 1. next[end]: the end of another
/// element that goes on from it and back to it, or `none`. Calls point(end) where each element begins and where the
/// last one ends, then finish(closed). Open chains come first, from the lower of their ends; what is left over are
/// loops.
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
