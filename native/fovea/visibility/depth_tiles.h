// SPDX-License-Identifier: GPL-3.0-or-later
// A view's depth buffer in tiles, where it is larger than textures or than memory allows.
#pragma once

#include <fovea/visibility/depth.h>

namespace fovea {

/// Layouts of at most `side` texels along each axis that together show what depth_layout shows. Their cores do not
/// overlap and leave nothing out; each shows `overlap_px` pixels around its core (less at the border), so that what is
/// decided inside the core looks at the very texels it would look at in the whole. One layout, the whole, where that is
/// small enough. Throws std::invalid_argument where a tile would have no core, and as depth_layout.
std::vector<DepthBuffer> depth_tiles(const View& view, const DepthOptions& options, int side, int overlap_px);

}  // namespace fovea
