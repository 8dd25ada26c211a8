// SPDX-License-Identifier: GPL-3.0-or-later
// The item buffer: which lines are seen at each texel (Northrup & Markosian 2000, "Artistic silhouettes: a hybrid
// approach", with one layer; Cole & Finkelstein 2008, "Partial visibility for stylized lines", with several and
// supersampling). What sampled visibility (sampled.h) is measured against.
#pragma once

#include <fovea/project/clipped_paths.h>
#include <fovea/visibility/depth.h>

namespace fovea::visibility {

struct ItemOptions {
    /// Nearest lines kept per texel: 1 .. 3.
    int layers = 1;
    /// Lines pass in front of a surface that is nearer by up to so many of its steps from texel to texel, as polygons
    /// are pushed back by glPolygonOffset, and by this share of its depth.
    float slope_factor = 1.0f, bias = 1e-5f;
};

/// Lines of a view, drawn one texel wide along their longer axis where the depth buffer does not hide them.
struct ItemBuffer {
    int width = 0, height = 0, layers = 0;
    /// layers entries a texel, nearest first: piece + 1, or 0 where there are no more. A piece is there once.
    Array<Index> items;

    bool holds(int x, int y, Index item) const;
};

/// Of lines at the same depth the later one lies in front. Throws std::invalid_argument on layers out of range and a
/// depth buffer without texels.
ItemBuffer draw_items(const ClippedPaths& clipped, const DepthBuffer& depth, const ItemOptions& options,
                      const Cancel* cancel = nullptr);

/// Share of its looks that see each atlas sample, in [0,1]; samples that the depth buffer does not decide are 0, as in
/// sampled_visibility. There are as many looks as texels to a pixel, evenly spread over the sample's share of the
/// segment; one sees where its texel, or the one on either side of the line, holds the piece in any layer.
Array<float> item_visibility(const ClippedPaths& clipped, const DepthBuffer& depth, const ItemOptions& options,
                             const Cancel* cancel = nullptr);

}  // namespace fovea::visibility
