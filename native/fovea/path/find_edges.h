// SPDX-License-Identifier: GPL-3.0-or-later
// Lines along edges that line sets request.
#pragma once

#include <fovea/path/chain.h>
#include <fovea/path/marked_edges.h>

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

/// View-independent lines of a surface for one style: those of each line set, and the edges that have any.
struct StaticLines {
    std::vector<MarkedEdges> of_sets;
    Array<Index> edges;
};

/// Edges of all line sets; with a view, of it, too.
struct FoundEdges {
    std::shared_ptr<const StaticLines> kept;
    std::vector<MarkedEdges> of_sets;
    Kinds doubled = 0;         ///< mesh-edge definitions whose smooth twin is requested
    Array<std::uint8_t> hard;  ///< at_hard_edges for these; or empty
};

/// Finds the edges of all line sets; with `of_view`, view-dependent ones, too. `sets_hash`: key of the cached part.
FoundEdges find_edges(SurfaceView seen, const std::vector<PlacedSet>& sets, std::uint64_t sets_hash, bool of_view);

/// Chains them, without mesh-edge contours beside a smooth one that is drawn: `near`, per vertex (near_curves), or
/// empty.
EdgePaths chain_edges(const SurfaceView& seen, const std::vector<PlacedSet>& sets, std::uint64_t sets_hash,
                      FoundEdges found, In<std::uint8_t> near);

}  // namespace fovea::path
