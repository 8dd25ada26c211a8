// SPDX-License-Identifier: GPL-3.0-or-later
// Pens resolved for one picture.
#pragma once

#include <array>

#include <fovea/style/pen.h>

namespace fovea::stroke {

using style::Anchor, style::Cap;

/// Gray image of ink in [0,1]: rows across the stroke (first row on the left of its direction), columns along it,
/// repeated.
struct PenTexture {
    int width = 0, height = 0;
    Array<float> ink;
    bool dashed = false;  ///< whether it was of dashes (ink.h) before it was fitted to a pen
    /// What two of its octaves are made one by (octaves.h); only if fitted to a pen that fixes marks to paths.
    Array<float> octaves{};

    In<float> row(int number) const {
        return {ink.data() + std::size_t(number) * std::size_t(width), std::size_t(width)};
    }
};

/// A style's pen, resolved for one picture.
struct Pen {
    style::Pen look;        ///< lengths in the image in pixels of this picture (in_pixels)
    float width_px = 2.0f;  ///< whatever look.width_unit
    /// Pixels of arc length that one repetition of the texture covers.
    float texture_length_px = 256.0f;
    /// Index into the frame's textures; `none`: solid.
    Index texture = none;
    /// Levels of the ink of its fitted texture (ink.h): a share k / 16 of it has at most [k]. 0 of a solid pen, and
    /// where lines do not break up.
    std::array<float, 17> ink_levels{};
    /// Index of the out-of-focus pen; `none`: this one.
    Index away = none;
};

/// Whether a pen fixes its marks to paths.
inline bool is_anchored(const Pen& pen) { return pen.look.texture_anchor == Anchor::path; }

/// What is painted where a pen draws, per point of Paths: what its width and its opacity are multiplied by, each in
/// [0, 1], and its color in place of its own. Empty: not painted. Borrowed.
struct PenPaint {
    In<float> width = {}, opacity = {};
    In<vec3> color = {};

    bool any() const { return !width.empty() || !opacity.empty() || !color.empty(); }
};

}  // namespace fovea::stroke
