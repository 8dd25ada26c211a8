// SPDX-License-Identifier: GPL-3.0-or-later
// Pens and their textures as the gpu's stroke pass reads them.
#pragma once

#include <fovea/stroke/pen.h>

namespace fovea {

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

}  // namespace fovea
