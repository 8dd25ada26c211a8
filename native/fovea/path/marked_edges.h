// SPDX-License-Identifier: GPL-3.0-or-later
// Edges that lines run along, as lists: they are few among the edges of a large mesh.
#pragma once

#include <fovea/path/placed_set.h>

namespace fovea::path {

/// An edge with lines of one line set.
struct MarkedEdge {
    Index edge;
    Kinds kinds;       ///< of the set
    std::uint8_t set;  ///< number of the set
};
using MarkedEdges = Array<MarkedEdge>;  // by edge, each once

/// The edges of the view-independent definitions that set number `number` requests (`of_surface`), or of the
/// view-dependent ones, for which `seen.facing` is needed; and those of `kept`.
MarkedEdges mark_edges(const PlacedSet& set, std::uint8_t number, const SurfaceView& seen, bool of_surface,
                       const MarkedEdges& kept = {});

/// The edges of several sets, of numbers below `edges`, each as the first set that has it marked it.
MarkedEdges of_first_sets(std::size_t edges, const std::vector<MarkedEdges>& of_sets);

}  // namespace fovea::path
