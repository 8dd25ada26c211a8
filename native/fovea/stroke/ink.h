// SPDX-License-Identifier: GPL-3.0-or-later
// Pen textures brought to the size at which a pen draws them.
#pragma once

#include <fovea/stroke/pen.h>

namespace fovea::stroke {

/// Area-filtered copy of a texture with at most one column per px of `length_px` and one row per px
/// of `width_px` (at least one of each); never larger than the texture. Drawn with bilinear
/// sampling it neither flickers nor loses ink: the mean stays the same. It has the means of its
/// rows. Throws where the texture is
/// empty or its array has the wrong size.
PenTexture fit_texture(const PenTexture& texture, float length_px, float width_px);

/// The texture of each pen as it draws it; empty for a solid one. Throws where a pen's texture, or its pen out of
/// focus, does not exist.
std::vector<PenTexture> fit_textures(In<Pen> pens, In<PenTexture> textures);

/// Pens and their textures as the gpu's stroke pass reads them.
struct PenTable {
    /// Three entries a pen: (color, number of the pen out of focus, or its own), (texture length [px], 1 for
    /// round caps, first entry of its ink, 1 for textures anchored to the path),
    /// (columns and rows of its ink: 0 for a solid pen, 0, 0).
    Array<vec4> pens;
    /// Textures fitted to their pens (ink.h), row after row, and after each its rows' means.
    Array<float> ink;
};

/// Throws where a pen's texture does not exist.
PenTable pen_table(In<Pen> pens, In<PenTexture> textures);

}  // namespace fovea::stroke
