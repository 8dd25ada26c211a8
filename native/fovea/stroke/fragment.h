// SPDX-License-Identifier: GPL-3.0-or-later
// What one fragment of a stroke adds to the picture. The shaders repeat this file line by line:
// change both.
#pragma once

#include <algorithm>
#include <cmath>

#include <fovea/stroke/pen.h>

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
    const float along = std::clamp(u - start + 0.5f, 0.0f, 1.0f) + std::clamp(end - u + 0.5f, 0.0f, 1.0f) - 1.0f;
    return side * std::max(along, 0.0f);
}

/// Ink of a texture in [0,1], bilinear: repeated along the stroke (`along`: in repetitions), held at
/// the sides. `texture` must be fitted to the pen (ink.h), so that no texel is much smaller than a
/// pixel.
inline float ink(const PenTexture& texture, float along, float v, float half_width) {
    const float x = (along - std::floor(along)) * texture.width - 0.5f;
    const float y =
        std::clamp((half_width - v) / (2.0f * half_width) * texture.height - 0.5f, 0.0f, float(texture.height - 1));
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

/// Mean along the stroke of the ink that `ink` gives at this v.
inline float mean_ink(const PenTexture& texture, float v, float half_width) {
    const float y =
        std::clamp((half_width - v) / (2.0f * half_width) * texture.height - 0.5f, 0.0f, float(texture.height - 1));
    const int y0 = int(y), y1 = std::min(y0 + 1, texture.height - 1);
    const float a = texture.row_mean[std::size_t(y0)], b = texture.row_mean[std::size_t(y1)];
    return a + (b - a) * (y - float(y0));
}

/// How a texture that is anchored to its path repeats along it: the finer of two octaves and its
/// share in the ink; the coarser one has half the repetitions.
struct Octave {
    float repeats, finer;
};

/// Repetitions along the whole path are a power of two, so that one in a zoom stays where it is, or
/// parts in two: of n = ceil(log2 level) for a path of `level` lengths of the texture. At the end of
/// an octave only the finer one is left: it is the coarser one of the next. Benard et al.,
/// "Self-Similar Line Artmaps", 2010. Paths below a pixel count as one.
inline Octave octave(float path_px, float texture_length_px) {
    const float level = std::max(path_px, 1.0f) / texture_length_px;
    const float repeats = std::exp2(std::ceil(std::log2(level)));
    return {repeats, std::clamp(2.0f * level / repeats - 1.0f, 0.0f, 1.0f)};
}

/// Ink of a texture anchored to a path of so many px, u px from its middle. Two octaves are blended,
/// and what the blend loses of the contrast along the line is given back about the mean of the row:
/// as dark, and as rough, all through a zoom; the profile across the line stays.
inline float anchored_ink(const PenTexture& texture, float u, float v, float half_width, float path_px,
                          float texture_length_px) {
    const Octave o = octave(path_px, texture_length_px);
    const float along = u / std::max(path_px, 1.0f) * o.repeats;
    const float fine = ink(texture, along, v, half_width), coarse = ink(texture, 0.5f * along, v, half_width);
    const float mean = mean_ink(texture, v, half_width), blend = coarse + (fine - coarse) * o.finer;
    const float kept = std::sqrt(o.finer * o.finer + (1.0f - o.finer) * (1.0f - o.finer));
    return std::clamp(mean + (blend - mean) / kept, 0.0f, 1.0f);
}

/// Ink over what is there; both premultiplied. alpha = coverage * ink * vertex opacity.
inline vec4 over(vec4 below, vec3 color, float alpha) { return vec4(color * alpha, alpha) + below * (1.0f - alpha); }

}  // namespace fovea
