// SPDX-License-Identifier: GPL-3.0-or-later
// Ink as a share of the paper's light, between pixels, too.
#pragma once

#include <cmath>

#include <fovea/color/png.h>
#include <fovea/study/bitmap.h>

namespace fovea::study {

/// How much darker than the paper each pixel is, [0, 1]; on dark paper, how much brighter.
struct Darkness {
    int width, height;
    Array<float> values;

    float at(int x, int y) const {
        const bool is_inside = x >= 0 && y >= 0 && x < width && y < height;
        return is_inside ? values[std::size_t(y) * std::size_t(width) + std::size_t(x)] : 0.0f;
    }
    float at(const vec2& p) const {
        const vec2 low = glm::floor(p - 0.5f), t = p - 0.5f - low;
        const int x = int(low.x), y = int(low.y);
        return std::lerp(std::lerp(at(x, y), at(x + 1, y), t.x), std::lerp(at(x, y + 1), at(x + 1, y + 1), t.x), t.y);
    }
};

/// `of_light`: half is half as much light, else half the value of a pixel.
Darkness darkness_of(const color::GrayImage& picture, bool of_light);

}  // namespace fovea::study
