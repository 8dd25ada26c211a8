// SPDX-License-Identifier: GPL-3.0-or-later
// Depth slope and facing of the facets at a line's own mesh edge.
#pragma once

#include <fovea/base/view.h>
#include <fovea/project/clipped_paths.h>
#include <fovea/scene/scene.h>

namespace fovea::visibility {

/// Per segment (indexed by its first point); the last point of a piece holds the same as a segment without facets.
struct OwnSides {
    /// Greatest depth slope (base/view.h) per pixel of the segment's front-facing facets: bounds how far the line's own
    /// surface, continued, rises in front of the line beside it. 0 where both are back-facing; at most max_depth_slope
    /// (depth.h), reached edge-on.
    Array<float> steepness;
    /// 1 where both adjacent facets are back-facing, or one is and the edge is concave: a solid would hide the line; it
    /// is visible on open surfaces only, next to its own facets. 0 where the facets do not occlude.
    Array<std::uint8_t> inner;

    /// Entry in the GPU's tables: the steepness, or -1 for an inner line.
    float in_tables(Index segment) const { return inner[segment] ? -1.0f : steepness[segment]; }
};

/// Throws std::invalid_argument, naming `what`, where they belong to other paths.
void check_sides(const ClippedPaths& clipped, const OwnSides& sides, const char* what);

OwnSides own_sides(const ClippedPaths& clipped, const Scene& scene, const View& view);

}  // namespace fovea::visibility
