// SPDX-License-Identifier: GPL-3.0-or-later
// The spine test (Cole & Finkelstein 2010, "Two fast methods for high-quality line visibility", algorithm 1): whole
// pieces become strokes, and every pixel of a stroke looks into the depth buffer where its spine is next to it.
#pragma once

#include <fovea/project/clipped_paths.h>
#include <fovea/visibility/depth.h>
#include <fovea/visibility/own_sides.h>
#include <fovea/visibility/runs.h>
#include <fovea/visibility/sampled.h>

namespace fovea::visibility {

/// Runs over the whole of every piece that has length: what the spine test draws.
Runs whole_pieces(const ClippedPaths& clipped);

/// Answers for pixels of strokes. Borrows all it is made of.
class SpineTest {
   public:
    /// Throws std::invalid_argument where the sides belong to other paths, and as sampled_visibility.
    SpineTest(const ClippedPaths& clipped, const OwnSides& sides, const DepthBuffer& buffer,
              const SampledOptions& options);

    /// Share of the probes, spread over a pixel along piece `piece` around arc length `u` [px], that see it, in [0,1].
    /// Before the start and beyond the end of the piece: as there.
    float visibility(Index piece, float u) const;

    /// Left, lower, right and upper edge [px] of what the depth buffer decides.
    const vec4& core() const { return buffer_.core; }

    /// Whether there is such a piece, and it has segments.
    bool has(Index piece) const { return piece < clipped_.pieces.count() && clipped_.pieces.size(piece) > 1; }

   private:
    const ClippedPaths& clipped_;
    const OwnSides& sides_;
    const DepthBuffer& buffer_;
    SampledOptions options_;
};

/// What the gpu's stroke pass reads, three entries a point; the last of a piece starts no segment:
/// (x0, y0, depth0, arc length at its start), (x1, y1, depth1, arc length at its end),
/// (facet0, facet1, steepness, or -1 for an inner line, 0).
Array<vec4> spine_table(const ClippedPaths& clipped, const OwnSides& sides);

}  // namespace fovea::visibility
