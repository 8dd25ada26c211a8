// SPDX-License-Identifier: GPL-3.0-or-later
// The filled inside of what the section plane cuts: poche.
#pragma once

#include <fovea/base/view.h>
#include <fovea/scene/section.h>

namespace fovea::color {

/// Draws a color under lines (width * height pixels, bottom row first, scene-linear and premultiplied) on the inside of
/// the section's sides (scene/section.h).
void fill_section(In<SectionSide> sides, const View& view, const vec3& color, std::span<vec4> lines);

}  // namespace fovea::color
