// SPDX-License-Identifier: GPL-3.0-or-later
// What stylized focus does to the color layer. Images are scene-linear and premultiplied, width * height pixels,
// amounts in [0, 1] per pixel (what is not a number counts as 0, what lies outside is clamped). Where the amount is 0
// pixels stay as they are, bit for bit. Thesis section 5.3.2.
#pragma once

#include <optional>

#include <fovea/base/types.h>

namespace fovea::color {

/// Moves colors towards the gray of their luminance (Rec. 709).
void desaturate(std::span<vec4> image, In<float> amount);

/// Moves colors towards one color; without one, the layer itself fades and shows what lies under it.
void fade(std::span<vec4> image, In<float> amount, const std::optional<vec3>& color);

/// Blurs each pixel as wide as a disc of its own radius would: colors diffuse where both neighbors are out of focus,
/// so that what is in focus bleeds nowhere and nothing bleeds into it, however near; the sum of the colors stays the
/// same, and the cost does not depend on the radius. Pixels that are not finite stay, and keep to themselves. Kass,
/// Lefohn & Owens, "Interactive Depth of Field Using Simulated Diffusion on a GPU", Pixar 2006.
void blur(std::span<vec4> image, int width, In<float> radius_px);

}  // namespace fovea::color
