// SPDX-License-Identifier: GPL-3.0-or-later
// Table of the methods of visibility.
#pragma once

#include <fovea/draw/frame.h>
#include <fovea/visibility/depth.h>

namespace fovea::draw {

struct Method {
    const char* words;  ///< its name in reports
    /// Visible runs of a frame's clipped paths. May fill Frame::samples.
    Runs (*visible)(Frame& frame);
    /// Visibility of each atlas sample, in [0, 1], from one tile of the depth buffer; null: the method takes no
    /// samples. For the spine test that is the atlas' answer, for comparison.
    Array<float> (*look)(const Frame& frame, const DepthBuffer& depth) = nullptr;
    int Options::* quality = nullptr;  ///< option that sets the quality; null: none
    const char* counted = "";          ///< unit that `quality` counts, for reports
    bool in_strokes = false;           ///< evaluated at every pixel while strokes are drawn
};

const Method& method_of(Visibility visibility);

}  // namespace fovea::draw
