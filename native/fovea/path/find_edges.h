// SPDX-License-Identifier: GPL-3.0-or-later
// Lines along edges that line sets request.
#pragma once

#include <fovea/path/chain.h>
#include <fovea/path/placed_set.h>

namespace fovea::path {

struct EdgeChains {
    std::shared_ptr<const Chains> chains;
    Array<Kinds> kinds;        // per point
    Array<std::uint8_t> free;  // per chain: FreeEnds
};

/// `kept`: view-independent chains, cached with the surface. `seen`: those of this view.
struct EdgePaths {
    EdgeChains kept, seen;
};

/// Definitions on mesh edges whose smooth twin is in `asked`.
Kinds doubled_edges(Kinds asked);

/// Finds and chains the edges of all line sets; with `of_view`, view-dependent ones, too. `near`: per vertex, from
/// near_smooth_contour, or empty. `sets_hash`: key of the cached part. Also returns at_hard_edges for the mesh-edge
/// contours that have a requested smooth twin (empty if there are none).
std::pair<EdgePaths, Array<std::uint8_t>> find_edges(SurfaceView seen, const std::vector<PlacedSet>& sets,
                                                     std::uint64_t sets_hash, bool of_view, In<std::uint8_t> near);

}  // namespace fovea::path
