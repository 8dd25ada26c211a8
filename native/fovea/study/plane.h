// SPDX-License-Identifier: GPL-3.0-or-later
// Pictures of one value per pixel, of any resolution.
#pragma once

#include <fovea/base/types.h>

namespace fovea::study {

using namespace vector;  // as bitmap.h has it

/// Bottom row first.
struct Plane {
    int width = 0, height = 0;
    Array<float> values;

    Plane() = default;
    Plane(int w, int h) : width(w), height(h), values(std::size_t(w) * std::size_t(h), 0.0f) {}

    float at(int x, int y) const { return values[std::size_t(y) * std::size_t(width) + std::size_t(x)]; }
    float& at(int x, int y) { return values[std::size_t(y) * std::size_t(width) + std::size_t(x)]; }
};

/// The same picture in width x height pixels: linear between pixels where there are more, else their mean under a tent
/// as wide as two new pixels. Mirrored pictures stay so.
Plane resized(const Plane& plane, int width, int height);

}  // namespace fovea::study
