// SPDX-License-Identifier: GPL-3.0-or-later
// The transfer function of sRGB (IEC 61966-2-1).
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>

#include <fovea/base/elementary.h>
#include <fovea/base/types.h>

namespace fovea::color {

/// Scene-linear from a value as displayed.
inline float from_srgb(float value) {
    return value <= 0.04045f ? value / 12.92f : float(power((value + 0.055f) / 1.055f, 2.4));
}

/// The other way around; both in [0,1].
inline float to_srgb(float linear) {
    return linear <= 0.0031308f ? 12.92f * linear : 1.055f * float(power(linear, 1.0 / 2.4)) - 0.055f;
}

/// A scene-linear color as displayed; channels outside of [0,1] are clamped.
inline dvec3 displayed(const dvec3& linear) {
    dvec3 color(0.0);
    for (int c = 0; c < 3; ++c) color[c] = to_srgb(std::clamp(float(linear[c]), 0.0f, 1.0f));
    return color;
}

/// A scene-linear value as a byte of a picture.
inline std::uint8_t srgb_byte(float linear) {
    return static_cast<std::uint8_t>(std::lround(255.0f * to_srgb(std::clamp(linear, 0.0f, 1.0f))));
}

}  // namespace fovea::color
