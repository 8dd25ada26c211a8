// SPDX-License-Identifier: GPL-3.0-or-later
// Loop over edges, shared by definitions on mesh edges.
#pragma once

#include <fovea/base/parallel.h>
#include <fovea/line/definition.h>

namespace fovea::line {

/// Sets `bit` on the edges [0, count) for which `is_line(edge)` holds.
template <typename IsLine>
void mark_edges(std::size_t count, Kinds bit, Array<Kinds>& kinds, const IsLine& is_line) {
    parallel_for(count, [&](std::size_t e) {
        if (is_line(static_cast<Index>(e))) kinds[e] |= bit;
    });
}

}  // namespace fovea::line
