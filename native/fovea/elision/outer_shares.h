// SPDX-License-Identifier: GPL-3.0-or-later
// How far contours of the mesh are silhouettes. A definition has an edge or has it not, so what goes by behind a long
// edge makes it a silhouette all at once; the share of what lies next to the edge grows steadily.
#pragma once

#include <fovea/base/parallel.h>
#include <fovea/path/paths.h>
#include <fovea/scene/tracer.h>

namespace fovea::elision {

/// What is known of a segment of a path.
struct OuterShare {
    float share = -1.0f;  ///< of a strip next to its edge in which its object has ended, in [0, 1]; below 0: not asked
    float inner = 0.0f;   ///< importance of the segment where its object goes on (line/definition.h)
};

/// Per point of Paths, of the segment from it. Rays at `places` of each path that is asked for (one entry per path);
/// of edges too short for two of them, and of what is no contour of a mesh, nothing is known.
Array<OuterShare> outer_shares(const Paths& paths, const Tracer& tracer, In<std::uint8_t> asked, const Cancel& cancel,
                               int places = 16);

}  // namespace fovea::elision
