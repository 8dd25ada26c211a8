// SPDX-License-Identifier: GPL-3.0-or-later
// Images on surfaces.
#pragma once

#include <fovea/base/types.h>

namespace fovea::color {

/// A tiled, mipmapped image of base colors. Stored as 8-bit sRGB: values are reflectances in [0, 1], not radiances.
class ColorTexture {
   public:
    /// `pixels`: rows from bottom to top, `channels` (1 gray, 2 gray and alpha, 3 or 4) values per pixel. Alpha is
    /// straight, and ignored. `encoded`: values are sRGB, else scene-linear. NaN is black. Throws std::invalid_argument
    /// if the sizes do not match.
    ColorTexture(In<float> pixels, int width, int height, int channels, bool encoded);

    /// Scene-linear color at uv; `footprint`: extent of a pixel, in uv units.
    vec3 at(const vec2& uv, float footprint) const;
    int width() const { return levels_[0].width; }
    int height() const { return levels_[0].height; }
    /// Hash of its pixels.
    std::uint64_t content() const;

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
