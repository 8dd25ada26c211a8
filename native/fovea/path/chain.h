// SPDX-License-Identifier: GPL-3.0-or-later
// Edges chained into paths on one surface.
#pragma once

#include <fovea/line/definition.h>

namespace fovea::path {

/// Chains of edges; points of chain c are rows.begin(c) .. rows.end(c).
struct Chains {
    Rows rows;
    Array<std::uint8_t> closed, label;  ///< per chain
    Array<Index> anchor;                ///< per chain: its lowest edge
    Array<Index> vertex;                ///< per point
    Array<Index> edge;                  ///< per point: edge to the next point; the last repeats the one before
};

/// Links edges of equal label that share a vertex. Where two meet, they are linked unless the path turns by more than
/// the label's corner angle (radians); where more meet, those that continue each other best are linked first. A vertex
/// with more than 32 lines ends them all. Turns are measured in space, or, for lines that depend on the view
/// (`in_image`), in the image: a contour of mesh edges zigzags in depth where it is smooth to the eye.
/// `edges` ascends; the result does not depend on the number of threads.
Chains chain(const SurfaceView& seen, bool in_image, In<Index> edges, In<std::uint8_t> labels,
             In<double> corner_angle_rad);

}  // namespace fovea::path
