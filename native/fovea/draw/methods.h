// SPDX-License-Identifier: GPL-3.0-or-later
// The methods of visibility, one row each: how it is decided what is hidden.
#pragma once

#include <fovea/draw/frame.h>
#include <fovea/visibility/depth.h>

namespace fovea::draw {

struct Method {
    const char* words;  ///< its name in reports
    /// What is visible of a frame's lines, once they are found. May fill Frame::samples.
    Runs (*visible)(Frame& frame);
    /// How visible each atlas sample is, in [0, 1], by one tile of the depth buffer; null: it takes no
    /// samples. The spine test does so only to be compared with the atlas.
    Array<float> (*look)(const Frame& frame, const DepthBuffer& depth) = nullptr;
    int Options::* quality = nullptr;  ///< null: none can be chosen
    const char* counted = "";          ///< what `quality` is a number of
    bool counts_surfaces = false;      ///< it can be told how many surfaces hide a line
    bool in_strokes = false;           ///< decided at every pixel, while strokes are drawn
};

const Method& method_of(Visibility visibility);

}  // namespace fovea::draw
