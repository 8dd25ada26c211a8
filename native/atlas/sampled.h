// Visibility of atlas samples by looking into a depth buffer.
#pragma once

#include "atlas/depth.h"
#include "project/clipped_paths.h"

namespace fovea {

struct SampledOptions {
    /// Places looked at per sample, within half a pixel of it: 1 (the sample itself) .. 16.
    int probes = 1;
    /// A line this share of its depth behind a surface still lies on it.
    float bias = 1e-5f;
    /// Pixels that the surface may be off sideways (rasterizers round corners to 1/256 pixel).
    float slack_px = 1.0f / 64.0f;
};

/// Share of its probes that see each atlas sample, in [0,1]; padding repeats the end of its piece.
///
/// A probe is hidden when each of the four texels around it hides it. A texel hides it when the plane of its surface,
/// extended to the probe, lies in front of the line; background and the two facets at the line's own edge never do.
/// So a line on a silhouette is seen past its surface's own bulge, and a hidden line shows at most one texel too early.
Array<float> sampled_visibility(const ClippedPaths& clipped, const DepthBuffer& buffer, const SampledOptions& options,
                                const Cancel* cancel = nullptr);

}  // namespace fovea
