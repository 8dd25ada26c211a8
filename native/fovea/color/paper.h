// SPDX-License-Identifier: GPL-3.0-or-later
// Paper that takes pigment: what color and lines look like on its tooth.
#pragma once

#include <fovea/base/view.h>
#include <fovea/style/ground.h>

namespace fovea::color {

/// A place on paper, as shares of all of it: any paper is spread evenly over [0, 1], and what follows keeps the mean.
struct PaperPlace {
    float lower = 0.5f;  ///< of the paper, lies lower
    float lit = 0.5f;    ///< of the paper, is lit less by light that comes from the upper left
};

/// Paper as heights, repeated over the picture.
struct PaperTexture {
    int width = 0, height = 0;
    Array<PaperPlace> places;  ///< rows from bottom to top

    PaperTexture() = default;
    /// Throws std::invalid_argument where there are not width * height heights. Not a number: the lowest.
    PaperTexture(In<float> heights, int width, int height);

    /// Bilinear, in texels.
    PaperPlace at(const vec2& texel) const;
};

/// Share of a place that ink of that opacity covers where `lower` of the paper is lower than there: heights first. The
/// mean over a paper is the opacity.
float toothed(float opacity, float lower, float tooth);

/// out = lines over layer over paper; scene-linear and premultiplied, one entry per pixel, bottom row first. `layer`
/// and `holdout` (share of the pixel where paper is cut out) may be empty; a layer lies, as opaque as `color` says, on
/// its background or on the paper, and its pigment granulates. The texture, if any, is fixed to where the view's axis
/// meets the picture, so that a border or a crop shows the same paper; where paper is transparent there is nothing
/// under the layer, but tooth still breaks lines up. `out` is resized.
void on_paper(In<vec4> lines, In<vec4> layer, In<float> holdout, const View& view, const PaperTexture* texture,
              const style::Paper& paper, const style::Color& color, Array<vec4>& out);

}  // namespace fovea::color
