// SPDX-License-Identifier: GPL-3.0-or-later
// The spine test (Cole & Finkelstein 2010, "Two fast methods for high-quality line visibility", algorithm 1): whole
// pieces become strokes, and every pixel of a stroke probes the depth buffer at the nearest point of its spine.
#pragma once

#include <fovea/project/clipped_paths.h>
#include <fovea/visibility/depth.h>
#include <fovea/visibility/own_sides.h>
#include <fovea/visibility/runs.h>
#include <fovea/visibility/sampled.h>

namespace fovea::visibility {

/// One run over the whole of every piece that has length: input of the spine test.
Runs whole_pieces(const ClippedPaths& clipped);

/// Evaluates the spine test for pixels of strokes. Borrows its arguments.
class SpineTest {
   public:
    /// Throws std::invalid_argument where the sides belong to other paths, and as sampled_visibility.
    SpineTest(const ClippedPaths& clipped, const OwnSides& sides, const DepthBuffer& buffer,
              const SampledOptions& options);

    /// Visibility in [0,1]: share of probes that are not hidden, spread over a pixel along `piece` around arc length
    /// `u` [px], clamped to the ends of the piece.
    float visibility(Index piece, float u) const;

    /// Left, lower, right and upper bound [px] of the depth buffer's core.
    const vec4& core() const { return buffer_.core; }

    /// Whether the piece exists and has segments.
    bool has(Index piece) const { return piece < clipped_.pieces.count() && clipped_.pieces.size(piece) > 1; }

   private:
    const ClippedPaths& clipped_;
    const OwnSides& sides_;
    const DepthBuffer& buffer_;
    SampledOptions options_;
};

/// Input table of the GPU's stroke pass, three entries per point; the last of a piece starts no segment:
/// (x0, y0, depth0, arc length at its start), (x1, y1, depth1, arc length at its end),
/// (facet0, facet1, steepness, or -1 for an inner line, 0).
Array<vec4> spine_table(const ClippedPaths& clipped, const OwnSides& sides);

}  // namespace fovea::visibility
