// SPDX-License-Identifier: GPL-3.0-or-later
// Chaining of edges into paths on one surface.
#pragma once

#include <fovea/line/definition.h>

namespace fovea::path {

/// Chains of edges; chain c has the points rows.begin(c) .. rows.end(c) - 1.
struct Chains {
    Rows rows;
    Array<std::uint8_t> closed, label;  ///< per chain
    Array<Index> anchor;                ///< per chain: its lowest edge index, from which ids are made
    Array<Index> vertex;                ///< per point
    /// Per point: the edge to the next point, and its number among the edges that were chained; the last point repeats
    /// the edge before it.
    Array<Index> edge, number;
};

/// Links edges of equal label that share a vertex. Two edges are linked only if the path turns by at most the label's
/// corner angle (radians); where more than two meet, pairs are linked greedily, straightest first. A vertex with more
/// than 32 edges ends all of them. Turns are measured in object space, or in the image for view-dependent lines
/// (`in_image`): a contour of mesh edges zigzags in depth where it looks smooth. `edges`: ascending. The result does
/// not depend on the number of threads.
Chains chain(const SurfaceView& seen, bool in_image, In<Index> edges, In<std::uint8_t> labels,
             In<double> corner_angle_rad);

}  // namespace fovea::path
