// SPDX-License-Identifier: GPL-3.0-or-later
// The color layer: the scene's surfaces in flat colors, lit or in bands, to lie under the lines.
#pragma once

#include <fovea/base/parallel.h>
#include <fovea/color/light.h>
#include <fovea/color/source.h>
#include <fovea/scene/tracer.h>

namespace fovea::color {

/// What each pixel sees (width * height, bottom row first): scene-linear, premultiplied, alpha the share of the pixel
/// that surfaces cover. Surfaces that let lines behind them show, and holdouts, have no color. One sample per pixel,
/// and 16 where neighbors look different: places of the triangles met around, and rays where none of them lies. No
/// shadows. Throws as ColorShader, and where a surface has moved since the tracer was made.
Array<vec4> color_layer(const Tracer& tracer, const SceneColor& colors, In<Light> lights, const vec3& world,
                        const style::Color& style, const Cancel& cancel);

}  // namespace fovea::color
