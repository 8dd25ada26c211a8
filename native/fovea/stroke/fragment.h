// SPDX-License-Identifier: GPL-3.0-or-later
// Shading of one fragment of a stroke: the formulas of shaders/shared/stroke.glsl, shared with the GPU, over the CPU's
// textures.
#pragma once

#include <fovea/stroke/pen.h>

namespace fovea::stroke {
namespace formulas {

using namespace glm;

struct Stroke {
    const PenTexture* texture = nullptr;

    float ink_texel(int index) const { return texture->ink[std::size_t(index)]; }
    float octave_value(int, ivec2, int index) const { return texture->octaves[std::size_t(index)]; }
    ivec2 size() const { return {texture->width, texture->height}; }

#include <shared/stroke.glsl>
};

}  // namespace formulas

inline float coverage(float u, float v, float start, float end, float half_width, Cap cap) {
    return formulas::Stroke{}.stroke_coverage(u, v, start, end, half_width, cap == Cap::round);
}

/// `along`: in repetitions of the texture, which must be fitted to the pen (ink.h).
inline float ink(const PenTexture& texture, float along, float v, float half_width) {
    formulas::Stroke stroke{&texture};
    return stroke.stroke_ink(0, stroke.size(), along, v, half_width);
}

/// What is left of ink where nothing is of `faint` ink and less (Strokes::mix).
inline float ink_left(float ink, float faint) { return formulas::Stroke{}.stroke_ink_left(ink, faint); }

/// Ink over `below`; both premultiplied. alpha = coverage * ink * vertex opacity.
inline vec4 over(vec4 below, vec3 color, float alpha) { return vec4(color * alpha, alpha) + below * (1.0f - alpha); }

}  // namespace fovea::stroke
