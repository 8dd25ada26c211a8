// SPDX-License-Identifier: GPL-3.0-or-later
// The lines along edges that line sets ask for.
#pragma once

#include <fovea/path/chain.h>
#include <fovea/path/placed_set.h>

namespace fovea {

/// Chains of edges: kept with the surface, and of this view; and their kinds by edge.
struct EdgePaths {
    std::shared_ptr<const Chains> kept;
    Chains seen;
    Array<Kinds> kept_kinds, seen_kinds;       // per point
    Array<std::uint8_t> kept_free, seen_free;  // per chain: FreeEnds
};

/// Definitions of mesh edges whose smooth twin is asked for.
Kinds doubled_edges(Kinds asked);

/// With those of this view, or only those that hold for all. Also, per vertex, `hard` of doubles.h. `near`: of
/// doubles.h, or empty. `sets_hash`: what the kept ones depend on.
std::pair<EdgePaths, Array<std::uint8_t>> find_edges(SurfaceView seen, const std::vector<PlacedSet>& sets,
                                                     std::uint64_t sets_hash, bool of_view, In<std::uint8_t> near);

}  // namespace fovea
