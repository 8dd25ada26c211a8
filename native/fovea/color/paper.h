// SPDX-License-Identifier: GPL-3.0-or-later
// Paper grain: appearance of color and lines on textured paper.
#pragma once

#include <fovea/base/view.h>
#include <fovea/style/ground.h>

namespace fovea::color {

/// A texel of paper, as quantiles: for any paper they are distributed evenly over [0, 1], so that effects derived from
/// them preserve the mean.
struct PaperPlace {
    float lower = 0.5f;  ///< fraction of the paper that lies lower
    float lit = 0.5f;    ///< fraction of the paper that is lit less by light from the upper left
};

/// Height map of paper, tiled over the picture.
struct PaperTexture {
    int width = 0, height = 0;
    double tile_mm = 0.0;      ///< width of the tile
    Array<PaperPlace> places;  ///< rows from bottom to top

    PaperTexture() = default;
    /// Throws std::invalid_argument unless there are width * height heights. NaN counts as the lowest.
    PaperTexture(In<float> heights, int width, int height, double tile_mm);

    /// Bilinear; `texel` in texels.
    PaperPlace at(const vec2& texel) const;
};

/// The places of a tiled height map under the pixels of a picture. It is fixed to where the view's axis meets the
/// picture, so that a border or a crop shows the same grain, and has its size in millimeters on the page at every
/// resolution.
class PlacesUnder {
   public:
    /// `texture`: null for paper without relief; `scale`: factor of its size.
    PlacesUnder(const PaperTexture* texture, double scale, const style::Paper& paper, const View& view);

    /// Calls body(place, share of the pixel) for places evenly spread over a pixel, given by its lower left corner:
    /// one, or several where texels are smaller than pixels.
    template <typename Body>
    void pixel(const vec2& corner, const Body& body) const {
        if (!texture_) return body(PaperPlace{}, 1.0f);
        const float step = 1.0f / float(along_), share = step * step;
        for (int y = 0; y < along_; ++y)
            for (int x = 0; x < along_; ++x) {
                const vec2 px = corner + (vec2(float(x), float(y)) + 0.5f) * step;
                body(texture_->at((px - origin_) / texel_px_), share);
            }
    }

   private:
    const PaperTexture* texture_;
    float texel_px_ = 1.0f;
    vec2 origin_{0.0f};
    int along_ = 1;  ///< places along a pixel
};

/// Coverage by ink of this opacity where the fraction `lower` of the paper lies lower: heights take ink first. Its mean
/// over the paper is the opacity.
float toothed(float opacity, float lower, float tooth);

/// out = lines over layer over paper; scene-linear and premultiplied, one entry per pixel, bottom row first. `layer`
/// and `holdout` (share of the pixel where paper is cut out) may be empty. The layer, with the opacity of `color`, is
/// composited over its background or over the paper, and its pigment granulates. On transparent paper there is nothing
/// under the layer, but tooth still breaks lines up. `density`: factor of the layer's optical density on its ground
/// (wash.h), may be empty. `out` is resized.
void on_paper(In<vec4> lines, In<vec4> layer, In<float> density, In<float> holdout, const View& view,
              const PaperTexture* texture, const style::Paper& paper, const style::Color& color, Array<vec4>& out);

}  // namespace fovea::color
