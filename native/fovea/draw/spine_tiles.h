// SPDX-License-Identifier: GPL-3.0-or-later
// The spine test of a frame's strokes, tile by tile of its depth buffer.
#pragma once

#include <functional>

#include <fovea/draw/frame.h>
#include <fovea/visibility/spine.h>

namespace fovea::draw {

/// Calls look(depth buffer) for each tile of a frame's depth buffer; only one tile is in memory at a time.
void each_depth_tile(const Frame& frame, int most_side, int overlap_px,
                     const std::function<void(const DepthBuffer&)>& look);

/// Calls draw(test) for each tile of the spine test, whose cores do not overlap; draw(nullptr), once, if strokes are
/// drawn as they are.
void each_spine_tile(const Frame& frame, int most_side, const std::function<void(const SpineTest*)>& draw);

}  // namespace fovea::draw
