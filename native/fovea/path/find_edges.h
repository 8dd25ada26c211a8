// SPDX-License-Identifier: GPL-3.0-or-later
// The lines along edges that line sets ask for.
#pragma once

#include <fovea/path/chain.h>
#include <fovea/path/placed_set.h>

namespace fovea::path {

struct EdgeChains {
    std::shared_ptr<const Chains> chains;
    Array<Kinds> kinds;        // per point
    Array<std::uint8_t> free;  // per chain: FreeEnds
};

/// Kept with the surface, and of this view.
struct EdgePaths {
    EdgeChains kept, seen;
};

/// Definitions of mesh edges whose smooth twin is asked for.
Kinds doubled_edges(Kinds asked);

/// With those of this view, or only those that hold for all. Also, per vertex, `hard` of doubles.h. `near`: of
/// doubles.h, or empty. `sets_hash`: what the kept ones depend on.
std::pair<EdgePaths, Array<std::uint8_t>> find_edges(SurfaceView seen, const std::vector<PlacedSet>& sets,
                                                     std::uint64_t sets_hash, bool of_view, In<std::uint8_t> near);

}  // namespace fovea::path
