// SPDX-License-Identifier: GPL-3.0-or-later
// Reference rasterizer of strokes; other backends are compared with it.
#pragma once

#include <fovea/stroke/pen.h>
#include <fovea/stroke/strokes.h>
#include <fovea/visibility/spine.h>

namespace fovea::stroke {

/// Draws the strokes: height rows of width pixels, bottom row first, scene-linear, premultiplied color and alpha,
/// triangles blended in order, fragments as in fragment.h. With `spine` the opacity of each fragment is multiplied by
/// the spine test at its u, and pixels outside of the depth buffer's core stay empty. Independent of the number of
/// threads. Throws where a stroke's pen, a pen's texture, a triangle's corner or (with `spine`) a vertex's piece does
/// not exist, or the size is not positive.
Array<vec4> rasterize(const Strokes& strokes, In<Pen> pens, In<PenTexture> textures, int width, int height,
                      const SpineTest* spine = nullptr);

}  // namespace fovea::stroke
