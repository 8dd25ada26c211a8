// SPDX-License-Identifier: GPL-3.0-or-later
// Visibility of atlas samples by looking into a depth buffer.
#pragma once

#include <fovea/project/clipped_paths.h>
#include <fovea/visibility/depth.h>
#include <fovea/visibility/own_sides.h>

namespace fovea::visibility {

struct SampledOptions {
    /// Places looked at per sample: 1 .. 16. They lie in the middles of equal parts of its share of the segment, where
    /// their mean is nearest to its coverage, and none beside the line: there an edge along the line would count as if
    /// it crossed it. Where the first and the last of them agree, they speak for all.
    int probes = 1;
    /// A line this share of its depth behind a surface still lies on it.
    float bias = 1e-5f;
    /// Pixels that the surface may be off sideways (rasterizers round corners to 1/256 pixel).
    float slack_px = 1.0f / 64.0f;
};

/// Throws std::invalid_argument on a number of probes out of range or a buffer without texels.
void check_sampled(const DepthBuffer& buffer, const SampledOptions& options);

/// Share of its probes that see each atlas sample, in [0,1]. Samples that the buffer does not decide are 0: the whole
/// is the sum over a view's tiles (depth_tiles).
///
/// A texel hides a probe when the plane of its surface, extended to the probe, lies in front of the line; background
/// and the two facets at the line's own edge never do. Which of the four texels around the probe decide:
/// - Any whose triangle (triangle_edges.h) reaches as far as the probe: what hides it is really there, on the near
///   side of its edge, even where the probe's own texel shows what is beyond.
/// - Else the texel the probe lies in, when it hides the line clearly: by more than surfaces as steep as its own, or as
///   the line's own facets, rise over the distance between the texel's center and the probe.
/// - Else all four: a silhouette lies a little behind the bulge of its own surface, but has open texels beside it.
/// - An inner line (own_sides.h) is seen where its texel does not hide it and one of the four shows an own facet.
///
/// Surfaces that are thinner in the image than a texel, and show in none of the four, are missed: lines hidden by them
/// alone, less than a texel beside their ends, may be seen.
Array<float> sampled_visibility(const ClippedPaths& clipped, const OwnSides& sides, const DepthBuffer& buffer,
                                const SampledOptions& options, const Cancel* cancel = nullptr);

/// The same for the part of a segment (of its first point) between two screen fractions.
float visibility_between(const ClippedPaths& clipped, const OwnSides& sides, Index segment, float t0, float t1,
                         const DepthBuffer& buffer, const SampledOptions& options);

}  // namespace fovea::visibility
