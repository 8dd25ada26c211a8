// SPDX-License-Identifier: GPL-3.0-or-later
#include <fovea/color/texture.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include <fovea/base/check.h>
#include <fovea/base/hash.h>
#include <fovea/base/parallel.h>
#include <fovea/color/srgb.h>

namespace fovea::color {
namespace {

std::uint8_t byte_of(float value) {
    return value > 0.0f ? static_cast<std::uint8_t>(std::min(value, 1.0f) * 255.0f + 0.5f) : 0;
}

const std::array<float, 256>& linear_of_byte() {
    static const std::array<float, 256> table = [] {
        std::array<float, 256> made;
        for (int i = 0; i < 256; ++i) made[i] = from_srgb(float(i) / 255.0f);
        return made;
    }();
    return table;
}

vec3 linear(const glm::u8vec4& texel) {
    const auto& table = linear_of_byte();
    return {table[texel.x], table[texel.y], table[texel.z]};
}

int wrapped(int i, int size) {
    i %= size;
    return i < 0 ? i + size : i;
}

}  // namespace

ColorTexture::ColorTexture(In<float> pixels, int width, int height, int channels, bool encoded) {
    check(width > 0 && height > 0 && channels >= 1 && channels <= 4, "texture: it has no pixels");
    check(pixels.size() == std::size_t(width) * height * channels, "texture: the number of values is not its size");
    levels_.push_back({width, height, Array<Texel>(std::size_t(width) * height)});
    parallel_for(levels_[0].texels.size(), [&](std::size_t i) {
        const float* p = &pixels[i * channels];
        const vec3 color = channels < 3 ? vec3(p[0]) : vec3(p[0], p[1], p[2]);
        Texel& texel = levels_[0].texels[i] = Texel(0);
        for (int c = 0; c < 3; ++c) texel[c] = byte_of(encoded ? color[c] : to_srgb(std::max(color[c], 0.0f)));
    });
    while (levels_.back().width > 1 || levels_.back().height > 1) {
        const Level& fine = levels_.back();
        Level half{std::max(fine.width / 2, 1), std::max(fine.height / 2, 1), {}};
        half.texels.resize(std::size_t(half.width) * half.height);
        parallel_for(half.height, 16, [&](std::size_t y) {
            for (int x = 0; x < half.width; ++x) {
                vec3 sum(0.0f);
                for (int i = 0; i < 4; ++i) {
                    const int fx = std::min(2 * x + (i & 1), fine.width - 1);
                    const int fy = std::min(2 * int(y) + (i >> 1), fine.height - 1);
                    sum += linear(fine.texels[std::size_t(fy) * fine.width + fx]);
                }
                Texel& texel = half.texels[y * half.width + x];
                for (int c = 0; c < 3; ++c) texel[c] = byte_of(to_srgb(0.25f * sum[c]));
            }
        });
        levels_.push_back(std::move(half));
    }
}

vec3 ColorTexture::at(const vec2& uv, float footprint) const {
    if (!std::isfinite(uv.x) || !std::isfinite(uv.y)) return vec3(0.0f);
    const float size = static_cast<float>(std::max(levels_[0].width, levels_[0].height));
    const float last = static_cast<float>(levels_.size() - 1);
    const float wanted = float(logarithm(std::max(footprint * size, 1.0f)) * std::numbers::log2e);
    const float level = wanted < last ? wanted : last;  // last level also for NaN
    const auto fine = static_cast<std::size_t>(level);
    const float share = level - static_cast<float>(fine);
    const vec3 color = bilinear(levels_[fine], uv);
    return share > 0.0f ? glm::mix(color, bilinear(levels_[fine + 1], uv), share) : color;
}

vec3 ColorTexture::bilinear(const Level& level, const vec2& uv) const {
    const vec2 unit = uv - glm::floor(uv);
    const vec2 at = unit * vec2(level.width, level.height) - 0.5f, low = glm::floor(at), share = at - low;
    const int x0 = wrapped(int(low.x), level.width), x1 = wrapped(int(low.x) + 1, level.width);
    const std::size_t y0 = std::size_t(wrapped(int(low.y), level.height)) * level.width;
    const std::size_t y1 = std::size_t(wrapped(int(low.y) + 1, level.height)) * level.width;
    const auto texel = [&](std::size_t row, int x) { return linear(level.texels[row + x]); };
    return glm::mix(glm::mix(texel(y0, x0), texel(y0, x1), share.x), glm::mix(texel(y1, x0), texel(y1, x1), share.x),
                    share.y);
}

std::uint64_t ColorTexture::content() const {
    const Level& whole = levels_[0];
    return hash_of(In<Texel>(whole.texels), hash_numbers(whole.width, whole.height));
}

}  // namespace fovea::color
