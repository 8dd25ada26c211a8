// SPDX-License-Identifier: GPL-3.0-or-later
#include <fovea/color/effects.h>

#include <algorithm>

#include <fovea/base/check.h>
#include <fovea/base/parallel.h>

namespace fovea::color {
namespace {

/// Calls body(pixel, amount) wherever the amount is above 0.
template <typename Body>
void where_any(std::span<vec4> image, In<float> amount, const Body& body) {
    check(amount.size() == image.size(), "color effect: expected one amount per pixel");
    parallel_blocks(image.size(), 1 << 15, [&](std::size_t, std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i)
            if (amount[i] > 0.0f) body(image[i], std::min(amount[i], 1.0f));
    });
}

}  // namespace

void desaturate(std::span<vec4> image, In<float> amount) {
    where_any(image, amount, [](vec4& pixel, float share) {
        const vec3 color(pixel);
        const float gray = glm::dot(color, vec3(0.2126f, 0.7152f, 0.0722f));
        pixel = vec4(glm::mix(color, vec3(gray), share), pixel.a);
    });
}

void fade(std::span<vec4> image, In<float> amount, const std::optional<vec3>& color) {
    if (!color)
        where_any(image, amount, [](vec4& pixel, float share) { pixel *= 1.0f - share; });
    else
        where_any(image, amount, [&](vec4& pixel, float share) {
            pixel = vec4(glm::mix(vec3(pixel), *color * pixel.a, share), pixel.a);
        });
}

}  // namespace fovea::color
