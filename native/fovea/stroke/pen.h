// SPDX-License-Identifier: GPL-3.0-or-later
// A pen: how a stroke looks.
#pragma once

#include <fovea/style/pen.h>

namespace fovea::stroke {

using style::Anchor, style::Cap;

/// Gray image of ink in [0,1], rows across the stroke (first row = left side of the way), columns along it, repeated.
struct PenTexture {
    int width = 0, height = 0;
    Array<float> ink;
    /// Per row: mean of its ink; only of textures fitted to a pen (ink.h).
    Array<float> row_mean{};
};

/// A style's pen, as one picture has it.
struct Pen {
    style::Pen look;        ///< its lengths in the image are in pixels of this picture: in_pixels
    float width_px = 2.0f;  ///< whatever the unit of the look's width
    /// Pixels of arc length that one repetition of the texture covers.
    float texture_length_px = 256.0f;
    /// Index into the frame's textures; `none`: solid.
    Index texture = none;
    /// Index of the pen that this one becomes out of focus; `none`: it stays as it is.
    Index away = none;
};

}  // namespace fovea::stroke
