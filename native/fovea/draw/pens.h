// SPDX-License-Identifier: GPL-3.0-or-later
// The pens of a style in pixels of the image.
#pragma once

#include <fovea/draw/assets.h>
#include <fovea/stroke/pen_range.h>
#include <fovea/style/style.h>

namespace fovea {

/// Pens of visible parts by line set, then those of hidden parts, then those out of focus.
struct Pens {
    std::vector<Pen> pens;
    std::vector<PenTexture> textures;  ///< as the pens number them
    std::vector<PenRange> ranges;      ///< which of them draws what (pen_range.h)
};

/// `scale`: pixels of the image that are a reference pixel. Throws as Assets.
Pens pens_of(const style::Style& style, const Assets& assets, double scale);

}  // namespace fovea
