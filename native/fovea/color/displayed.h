// SPDX-License-Identifier: GPL-3.0-or-later
// Pixels as files have them and programs mix them: as displayed (sRGB), where pictures are scene-linear.
#pragma once

#include <fovea/base/columns.h>

namespace fovea::color {

/// Opacity with which a color over paper looks the same where displayed values are mixed, as by programs that show
/// vectors and layers, as where light is, as in pictures. Both scene-linear; by their means.
double displayed_opacity(double opacity, const dvec3& color, const dvec3& paper);

/// Bytes of premultiplied scene-linear pixels: color and alpha, by which colors are not multiplied, or color over white
/// alone.
Array<std::uint8_t> displayed_bytes(In<vec4> pixels, bool with_alpha);

/// Bytes of color and alpha of what lies on paper of this color: of lines, say.
Array<std::uint8_t> bytes_over(In<vec4> pixels, const dvec3& paper);

/// Bytes of color and alpha that make of the pixels below, mixed as displayed, those above; both scene-linear. Alpha is
/// at least `coverage`, and as low as colors allow.
Array<std::uint8_t> bytes_between(In<vec4> below, In<vec4> above, In<vec4> coverage);

}  // namespace fovea::color
