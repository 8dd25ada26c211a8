// SPDX-License-Identifier: GPL-3.0-or-later
// Images on surfaces.
#pragma once

#include <fovea/base/types.h>

namespace fovea::color {

/// An image of base colors, repeated over the plane; smaller copies of it serve where it is seen from far away.
/// Colors are kept as 8-bit sRGB: shares of light that is reflected, not light.
class ColorTexture {
   public:
    /// `pixels`: rows from bottom to top, `channels` (1 gray, 2 gray and alpha, 3 or 4) values per pixel. Alpha is
    /// straight, and left out. `encoded`: as sRGB, else scene-linear. What is not a number is black. Throws
    /// std::invalid_argument when the sizes do not fit together.
    ColorTexture(In<float> pixels, int width, int height, int channels, bool encoded);

    /// Scene-linear color at a place of the unit square; `footprint`: how much of the square one pixel sees.
    vec3 at(const vec2& uv, float footprint) const;
    int width() const { return levels_[0].width; }
    int height() const { return levels_[0].height; }

   private:
    using Texel = glm::u8vec4;
    struct Level {
        int width, height;
        Array<Texel> texels;
    };
    vec3 bilinear(const Level& level, const vec2& uv) const;
    std::vector<Level> levels_;
};

}  // namespace fovea::color
