// SPDX-License-Identifier: GPL-3.0-or-later
// A picture as layers, for programs that paint: paper, colors, and the lines of each line set apart.
#pragma once

#include <fovea/draw/frame.h>

namespace fovea::draw {

/// As large as the picture; a PNG with alpha.
struct PictureLayer {
    std::string group;  ///< its line set, numbered; empty: of none
    std::string name;
    std::string png;
};

struct LayeredPicture {
    std::vector<PictureLayer> layers;  ///< from below
    std::string merged;                ///< PNG of the picture
    std::string thumbnail;             ///< the same, at most 256 pixels along a side
};

/// Takes all steps. Layers without anything drawn are left out. Mixed as displayed, as programs do, colors on paper are
/// those of the picture, and each line over bare paper is; where faint lines cross, the two differ a little.
LayeredPicture layered(Frame& frame);

}  // namespace fovea::draw
