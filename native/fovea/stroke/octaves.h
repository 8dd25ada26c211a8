// SPDX-License-Identifier: GPL-3.0-or-later
// What two octaves of a pen's texture are made one by, so that it divides in two where a line grows: grain by mixing,
// dashes by gaps that open.
#pragma once

#include <fovea/stroke/pen.h>

namespace fovea::stroke {

/// PenTexture::octaves of a texture of W columns and H rows that is fitted to its pen (ink.h), as
/// shaders/shared/stroke.glsl reads them, row after row. Of grain: the mean of each row. Of dashes: H x W ranks of the
/// texels in their rows, as shares in (0, 1), of equals the mean, from the middles of gaps to those of dashes; H x W
/// ink of each row in the order of ranks; H x 17 shifts of ranks with which about as much of a row stays ink, for
/// equally spaced shares of the finer octave.
Array<float> octaves_of(const PenTexture& fitted);

/// Ink of a texture with octaves at a place on a path, of which all has path_px pixels; v: across the stroke [px].
float anchored_ink(const PenTexture& texture, float along, float v, float half_width, float path_px,
                   float texture_length_px);

}  // namespace fovea::stroke
