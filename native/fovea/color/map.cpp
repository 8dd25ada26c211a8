// SPDX-License-Identifier: GPL-3.0-or-later
#include <fovea/color/map.h>

#include <fovea/focus/at_samples.h>

namespace fovea::color {

Array<float> map_of_samples(const ClippedPaths& clipped, const View& view, const ColorTexture& image) {
    const vec2 corner(view.frame.x, view.frame.y), size(view.frame.z, view.frame.w);
    // Clamped half a texel inside the borders, so that the tiled image does not wrap around.
    const vec2 border = 0.5f / vec2(image.width(), image.height());
    return at_samples(clipped, [&](const SamplePlace& at) {
        const vec2 uv = glm::clamp((px_at(clipped, at) - corner) / size, border, 1.0f - border);
        return glm::dot(image.at(uv, 0.0f), vec3(0.2126f, 0.7152f, 0.0722f));
    });
}

}  // namespace fovea::color
