// SPDX-License-Identifier: GPL-3.0-or-later
// Pen textures resampled to the size at which a pen draws them.
#pragma once

#include <fovea/stroke/pen.h>

namespace fovea::stroke {

/// Pen::ink_levels of a texture; of an empty one 0.
std::array<float, 17> ink_levels(const PenTexture& texture);

double mean_ink(In<float> ink);

/// Whether the middle of a texture has gaps, and hardly anything between ink and none; not of an empty one.
bool is_dashed(const PenTexture& texture);

/// Area-filtered copy of a texture with at most one column per px of `length_px` and one row per px of `width_px` (at
/// least one of each); never larger than the texture. The mean is preserved, so bilinear sampling neither flickers nor
/// loses ink. Throws if the texture is empty or its array has the wrong size.
PenTexture fit_texture(const PenTexture& texture, float length_px, float width_px);

/// The fitted texture of each pen, with octaves where it fixes marks to paths; empty for a solid one. Throws if a pen's
/// texture, or its out-of-focus pen, does not exist.
std::vector<PenTexture> fit_textures(In<Pen> pens, In<PenTexture> textures);

/// Pens and their textures as input of the GPU's stroke pass.
struct PenTable {
    /// Four entries per pen: (color, index of the out-of-focus pen, or its own), (texture length [px], 1 for round
    /// caps, first entry of its ink, 1 for textures anchored to the path),
    /// (columns and rows of its ink: 0 for a solid pen, 1 for dashes, 0), (second color, 0).
    Array<vec4> pens;
    /// Textures fitted to their pens, each row by row, followed by what two of its octaves are made one by.
    Array<float> ink;
};

/// Throws if a pen's texture does not exist.
PenTable pen_table(In<Pen> pens, In<PenTexture> textures);

}  // namespace fovea::stroke
