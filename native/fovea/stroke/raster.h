// SPDX-License-Identifier: GPL-3.0-or-later
// The reference picture of strokes; other backends are compared with it.
#pragma once

#include <fovea/stroke/pen.h>
#include <fovea/stroke/strokes.h>
#include <fovea/visibility/spine.h>

namespace fovea::stroke {

/// Draws the strokes into `image` (height rows of width pixels, bottom row first; resized and
/// overwritten): scene-linear, premultiplied color and alpha, triangle over triangle in their
/// order, fragments as in fragment.h. With `spine` every fragment is as opaque as its stroke is visible
/// at its u, and pixels outside the core of its depth buffer stay empty. The same for any number of threads. Throws
/// where a stroke's pen, a pen's texture, a triangle's corner or (with `spine`) a vertex's piece does not exist, or the
/// size is not positive.
void rasterize(const Strokes& strokes, In<Pen> pens, In<PenTexture> textures, int width, int height, Array<vec4>& image,
               const SpineTest* spine = nullptr);

}  // namespace fovea::stroke
