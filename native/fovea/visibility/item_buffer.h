// SPDX-License-Identifier: GPL-3.0-or-later
// The item buffer: numbers of the lines visible at each texel (Northrup & Markosian 2000, "Artistic silhouettes: a
// hybrid approach", with one layer; Cole & Finkelstein 2008, "Partial visibility for stylized lines", with several and
// supersampling). The baseline for sampled visibility (sampled.h).
#pragma once

#include <fovea/project/clipped_paths.h>
#include <fovea/visibility/depth.h>

namespace fovea::visibility {

struct ItemOptions {
    /// Nearest lines kept per texel: 1 .. 3.
    int layers = 1;
    /// A surface hides a line only if it is nearer by more than slope_factor times its depth change per texel, as in
    /// glPolygonOffset, plus `bias` times its depth.
    float slope_factor = 1.0f, bias = 1e-5f;
};

/// Lines of a view, rasterized one texel wide along their major axis and tested against the depth buffer.
struct ItemBuffer {
    int width = 0, height = 0, layers = 0;
    /// `layers` entries per texel, nearest first: piece + 1, or 0 if empty. A piece occurs at most once per texel.
    Array<Index> items;

    bool holds(int x, int y, Index item) const;
};

/// At equal depth the later line is in front. Throws std::invalid_argument on layers out of range and a depth buffer
/// without texels.
ItemBuffer draw_items(const ClippedPaths& clipped, const DepthBuffer& depth, const ItemOptions& options,
                      const Cancel* cancel = nullptr);

/// Visibility of each atlas sample in [0,1]: share of its probes that find the piece. Samples outside of the depth
/// buffer's core are 0, as in sampled_visibility. There are as many probes as texels along a pixel, evenly spread over
/// the sample's part of the segment; a probe finds the piece if its texel, or the one on either side across the line,
/// holds it in any layer.
Array<float> item_visibility(const ClippedPaths& clipped, const DepthBuffer& depth, const ItemOptions& options,
                             const Cancel* cancel = nullptr);

}  // namespace fovea::visibility
