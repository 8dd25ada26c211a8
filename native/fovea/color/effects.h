// SPDX-License-Identifier: GPL-3.0-or-later
// Effects of stylized focus on the color layer. Images are scene-linear and premultiplied, width * height pixels,
// amounts in [0, 1] per pixel (NaN counts as 0, values outside are clamped). Where the amount is 0 pixels are
// unchanged, bit for bit. Cole 2009, section 5.3.2.
#pragma once

#include <optional>

#include <fovea/base/types.h>

namespace fovea::color {

/// Mixes colors with the gray of their luminance (Rec. 709).
void desaturate(std::span<vec4> image, In<float> amount);

/// Mixes colors with `color`; without one, the layer itself becomes transparent.
void fade(std::span<vec4> image, In<float> amount, const std::optional<vec3>& color);

/// Blurs with a radius per pixel, of the same variance as a disc of that radius. Colors diffuse only between neighbors
/// that are both out of focus, so that nothing bleeds into or out of what is in focus, however near. The sum of the
/// colors is preserved, and the cost does not depend on the radius. Non-finite pixels are unchanged and do not diffuse.
/// Kass, Lefohn & Owens, "Interactive Depth of Field Using Simulated Diffusion on a GPU", Pixar 2006.
void blur(std::span<vec4> image, int width, In<float> radius_px);
void blur(std::span<float> image, int width, In<float> radius_px);

}  // namespace fovea::color
