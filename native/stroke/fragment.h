// What one fragment of a stroke adds to the picture. The shaders repeat this file line by line:
// change both.
#pragma once

#include <algorithm>
#include <cmath>

#include "stroke/pen.h"

namespace fovea {

/// Share of the pixel that the stroke covers, in [0,1]. All in px: u along the path, v across, u of
/// the run's start and end, half the drawn width. The edge is a ramp one pixel wide, centred on the
/// true edge.
inline float coverage(float u, float v, float start, float end, float half_width, Cap cap) {
    if (cap == Cap::round) {
        const float beyond = std::max(std::max(start - u, u - end), 0.0f);
        const float distance = beyond > 0.0f ? std::sqrt(beyond * beyond + v * v) : std::abs(v);
        return std::clamp(half_width - distance + 0.5f, 0.0f, 1.0f);
    }
    const float side = std::clamp(half_width - std::abs(v) + 0.5f, 0.0f, 1.0f);
    // The pixel's share on this side of the end, less its share before the start: exact for runs of
    // any length.
    const float along =
        std::clamp(u - start + 0.5f, 0.0f, 1.0f) + std::clamp(end - u + 0.5f, 0.0f, 1.0f) - 1.0f;
    return side * std::max(along, 0.0f);
}

/// Ink of a texture in [0,1], bilinear: repeated along u, held at the sides. `texture` must be
/// fitted to the pen (ink.h), so that no texel is much smaller than a pixel.
inline float ink(const PenTexture& texture, float u, float v, float half_width,
                 float texture_length_px) {
    const float along = u / texture_length_px;
    const float x = (along - std::floor(along)) * texture.width - 0.5f;
    const float y = std::clamp((half_width - v) / (2.0f * half_width) * texture.height - 0.5f, 0.0f,
                               float(texture.height - 1));
    const int x0 = int(std::floor(x)), y0 = int(y);
    const float fx = x - float(x0), fy = y - float(y0);
    const int left = x0 < 0 ? texture.width - 1 : x0;
    const int right = x0 + 1 < texture.width ? x0 + 1 : 0;
    const float* upper = texture.ink.data() + std::size_t(y0) * texture.width;
    const float* lower = y0 + 1 < texture.height ? upper + texture.width : upper;
    const float a = upper[left] + (upper[right] - upper[left]) * fx;
    const float b = lower[left] + (lower[right] - lower[left]) * fx;
    return a + (b - a) * fy;
}

/// Ink over what is there; both premultiplied. alpha = coverage * ink * vertex opacity.
inline vec4 over(vec4 below, vec3 color, float alpha) {
    return vec4(color * alpha, alpha) + below * (1.0f - alpha);
}

}  // namespace fovea
