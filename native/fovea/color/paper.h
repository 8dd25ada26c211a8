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
    Array<PaperPlace> places;  ///< rows from bottom to top

    PaperTexture() = default;
    /// Throws std::invalid_argument unless there are width * height heights. NaN counts as the lowest.
    PaperTexture(In<float> heights, int width, int height);

    /// Bilinear; `texel` in texels.
    PaperPlace at(const vec2& texel) const;
};

/// Coverage by ink of this opacity where the fraction `lower` of the paper lies lower: heights take ink first. Its mean
/// over the paper is the opacity.
float toothed(float opacity, float lower, float tooth);

/// out = lines over layer over paper; scene-linear and premultiplied, one entry per pixel, bottom row first. `layer`
/// and `holdout` (share of the pixel where paper is cut out) may be empty. The layer, with the opacity of `color`, is
/// composited over its background or over the paper, and its pigment granulates. The texture, if any, is fixed to where
/// the view's axis meets the picture, so that a border or a crop shows the same grain; on transparent paper there is
/// nothing under the layer, but tooth still breaks lines up. `out` is resized.
void on_paper(In<vec4> lines, In<vec4> layer, In<float> holdout, const View& view, const PaperTexture* texture,
              const style::Paper& paper, const style::Color& color, Array<vec4>& out);

}  // namespace fovea::color
