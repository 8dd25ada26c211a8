// SPDX-License-Identifier: GPL-3.0-or-later
// The depth buffer of a frame, in tiles where it is large.
#pragma once

#include <fovea/draw/frame.h>
#include <fovea/visibility/depth_tiles.h>

namespace fovea {

/// Layouts in at most `most_side` texels along each axis: one, or tiles. Cores are looked out of by so many pixels,
/// besides what a sample's own probes are apart.
std::vector<DepthBuffer> depth_layouts(const Frame& frame, int most_side, int overlap_px);

/// Pixels between a stroke's spine and its farthest fragment, and no less.
int strokes_reach_px(const Strokes& strokes);

}  // namespace fovea
