// SPDX-License-Identifier: GPL-3.0-or-later
#include <fovea/color/displayed.h>

#include <algorithm>
#include <cmath>

#include <fovea/base/parallel.h>
#include <fovea/color/srgb.h>

namespace fovea::color {
namespace {

constexpr float least_difference = 0.01f;  // of a color from its paper, both as displayed
constexpr float unseen = 0.5f / 255.0f;

std::uint8_t byte_of(double value) {
    return static_cast<std::uint8_t>(std::lround(255.0 * std::clamp(value, 0.0, 1.0)));
}

float mean(const dvec3& color) { return std::clamp(float(color.x + color.y + color.z) / 3.0f, 0.0f, 1.0f); }

/// Opacity that is needed to make one displayed value of another.
double needed(double below, double above) {
    const double change = above - below;
    if (std::abs(change) < unseen) return 0.0;
    return change / (change > 0.0 ? 1.0 - below : -below);
}

}  // namespace

double displayed_opacity(double opacity, const dvec3& color, const dvec3& paper) {
    const float ink = mean(color), below = mean(paper);
    const float whole = to_srgb(below) - to_srgb(ink);
    if (std::abs(whole) < least_difference) return opacity;
    const float mixed = glm::mix(below, ink, float(std::clamp(opacity, 0.0, 1.0)));
    return (to_srgb(below) - to_srgb(mixed)) / whole;
}

Array<std::uint8_t> displayed_bytes(In<vec4> pixels, bool with_alpha) {
    const std::size_t channels = with_alpha ? 4 : 3;
    Array<std::uint8_t> bytes(channels * pixels.size());
    parallel_for(pixels.size(), [&](std::size_t i) {
        const vec4& pixel = pixels[i];
        const float alpha = std::clamp(pixel.a, 0.0f, 1.0f);
        const vec3 color = !with_alpha ? vec3(pixel) + 1.0f - pixel.a : alpha > 0.0f ? vec3(pixel) / alpha : vec3(0.0f);
        for (int c = 0; c < 3; ++c) bytes[channels * i + c] = srgb_byte(color[c]);
        if (with_alpha) bytes[channels * i + 3] = byte_of(alpha);
    });
    return bytes;
}

Array<std::uint8_t> bytes_over(In<vec4> pixels, const dvec3& paper) {
    Array<std::uint8_t> bytes = displayed_bytes(pixels, true);
    parallel_for(pixels.size(), [&](std::size_t i) {
        const vec4& pixel = pixels[i];
        if (pixel.a > 0.0f) bytes[4 * i + 3] = byte_of(displayed_opacity(pixel.a, dvec3(vec3(pixel) / pixel.a), paper));
    });
    return bytes;
}

Array<std::uint8_t> bytes_between(In<vec4> below, In<vec4> above, In<vec4> coverage) {
    Array<std::uint8_t> bytes(4 * below.size());
    parallel_for(below.size(), [&](std::size_t i) {
        const dvec3 from = displayed(dvec3(vec3(below[i]))), to = displayed(dvec3(vec3(above[i])));
        double alpha = coverage.empty() ? 0.0 : std::clamp(coverage[i].a, 0.0f, 1.0f);
        for (int c = 0; c < 3; ++c) alpha = std::max(alpha, needed(from[c], to[c]));
        for (int c = 0; c < 3; ++c)
            bytes[4 * i + c] = alpha > 0.0 ? byte_of(from[c] + (to[c] - from[c]) / alpha) : std::uint8_t(0);
        bytes[4 * i + 3] = byte_of(alpha);
    });
    return bytes;
}

}  // namespace fovea::color
