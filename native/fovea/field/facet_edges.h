// SPDX-License-Identifier: GPL-3.0-or-later
// The edges of each facet, and how much the surface turns at them: what creases, bevels and strips are found by.
#pragma once

#include <fovea/base/parallel.h>
#include <fovea/field/turn.h>

namespace fovea::field {

/// Refers to its surface.
struct FacetEdges {
    explicit FacetEdges(const Surface& of)
        : surface(of), turn(parallel_map<float>(of.edges.size(), [&](std::size_t e) {
              return static_cast<float>(signed_turn(of, static_cast<Index>(e)));
          })) {
        of_facet = lists_of<Index>(of.facet_count(), [&](const auto& give) {
            for (Index e = 0; e < of.edges.size(); ++e)
                for (const EdgeSide side : of.sides(e)) give(side.facet(), e);
        });
    }

    const Surface& surface;
    Array<float> turn;      ///< signed_turn per edge
    Lists<Index> of_facet;  ///< edges, ascending
};

}  // namespace fovea::field
