// SPDX-License-Identifier: GPL-3.0-or-later
// A pen: how a stroke looks.
#pragma once

#include <fovea/style/style.h>

namespace fovea {

using style::Anchor, style::Cap;

/// Grey image of ink in [0,1], rows across the stroke (first row = left side of the way), columns along it, repeated.
struct PenTexture {
    int width = 0, height = 0;
    Array<float> ink;
    /// Per row: mean of its ink; only of textures fitted to a pen (ink.h).
    Array<float> row_mean{};
};

/// Lengths in pixels of the image (the caller multiplies reference pixels by View::reference_scale).
struct Pen {
    vec3 color{0.0f};
    float opacity = 1.0f;
    float width_px = 2.0f;
    /// Pixels of arc length that one repetition of the texture covers.
    float texture_length_px = 256.0f;
    Anchor anchor = Anchor::screen;
    Cap cap = Cap::round;
    float taper_px = 0.0f;
    /// Share of a line's strength that thins it; the rest fades it. 0: weak lines are pale, 1: weak lines are thin.
    float strength_width = 0.0f;
    /// How far the pen strays from its line, in waves of what length, and the number of that hand.
    float wobble_px = 0.0f, wobble_length_px = 60.0f;
    Index seed = 0;
    /// Share of the width that is left out at the ends of a stroke.
    float pressure = 0.0f;
    /// Index into the frame's textures; `none`: solid.
    Index texture = none;
    /// Index of the pen that this one becomes out of focus; `none`: it stays as it is.
    Index away = none;
};

}  // namespace fovea
