// SPDX-License-Identifier: GPL-3.0-or-later
// Visibility of atlas samples by probes of a depth buffer.
#pragma once

#include <fovea/project/clipped_paths.h>
#include <fovea/visibility/depth.h>
#include <fovea/visibility/own_sides.h>

namespace fovea::visibility {

struct SampledOptions {
    /// Probes per sample: 1 .. 16, at the middles of equal parts of the sample's interval of the segment, where their
    /// mean is nearest to its coverage. None lie beside the line: there, an edge along the line would count as if it
    /// crossed it. If the first and the last probe agree, the others are skipped.
    int probes = 1;
    /// Depth tolerance, as a fraction of the surface's depth: a line that little behind a surface lies on it.
    float bias = 1e-5f;
    /// Lateral tolerance of the surface [px] (rasterizers round corners to 1/256 pixel).
    float slack_px = 1.0f / 64.0f;
};

/// Throws std::invalid_argument on a number of probes out of range or a buffer without texels.
void check_sampled(const DepthBuffer& buffer, const SampledOptions& options);

/// Visibility of each atlas sample in [0,1]: share of its probes that are not hidden. Samples outside of the buffer's
/// core are 0, so that the result for a view is the sum over its tiles (depth_tiles).
///
/// A texel hides a probe when the plane of its surface, extended to the probe, lies in front of the line; background
/// and the two facets at the line's own edge never do. Which of the four texels around the probe decide:
/// - Any whose triangle (triangle_edges.h) extends to the probe: its surface covers the probe, even where the probe's
///   own
///   texel shows what lies beyond that surface's edge.
/// - Else the texel the probe lies in, if it hides the line clearly: by more than the depth difference over the
///   distance between the texel's center and the probe, at the slope of its surface or of the line's own facets.
/// - Else all four together: a silhouette lies slightly behind the bulge of its own surface, but has texels beside it
///   that do not hide it.
/// - An inner line (own_sides.h) is visible where its texel does not hide it and one of the four shows an own facet.
///
/// Surfaces that are thinner in the image than a texel, and show in none of the four, are missed: lines hidden by them
/// alone, less than a texel beside their ends, may come out visible.
Array<float> sampled_visibility(const ClippedPaths& clipped, const OwnSides& sides, const DepthBuffer& buffer,
                                const SampledOptions& options, const Cancel* cancel = nullptr);

/// The same for the part of `segment` (index of its first point) between two screen fractions.
float visibility_between(const ClippedPaths& clipped, const OwnSides& sides, Index segment, float t0, float t1,
                         const DepthBuffer& buffer, const SampledOptions& options);

}  // namespace fovea::visibility
