// SPDX-License-Identifier: GPL-3.0-or-later
// The color layer under the lines: the scene's surfaces in flat, smooth or toon shading.
#pragma once

#include <fovea/base/parallel.h>
#include <fovea/color/light.h>
#include <fovea/color/source.h>
#include <fovea/scene/tracer.h>

namespace fovea::color {

/// Renders the layer (width * height, bottom row first): scene-linear, premultiplied, alpha is the coverage by
/// surfaces; holdouts have no color. Surfaces that do not occlude lines are composited over it (sheets.h). One sample
/// per pixel, and 16 where neighbors differ; these test the triangles found around the pixel, and cast rays where none
/// of them covers the sample. Where the style wants shadows or blacks, also where those differ. Throws as ColorShader,
/// and where a surface has moved since the tracer was made.
Array<vec4> color_layer(const Tracer& tracer, const SceneColor& colors, In<Light> lights, const vec3& world,
                        const style::Color& style, const Cancel& cancel);

}  // namespace fovea::color
