// SPDX-License-Identifier: GPL-3.0-or-later
// Diffusion with spatially varying conductivity, solved implicitly along rows and columns in turn.
#include <algorithm>
#include <atomic>
#include <cmath>

#include <fovea/base/check.h>
#include <fovea/base/parallel.h>
#include <fovea/color/effects.h>

namespace fovea::color {
namespace {

/// Number of passes along both axes; more make the kernel rounder.
constexpr int rounds = 2;
/// Maximum radius [px]: as wide as any picture.
constexpr float most_px = 1e4f;
/// Columns solved simultaneously: a few cache lines.
constexpr std::size_t side_by_side = 16;

bool finite(const vec4& pixel) { return std::isfinite(pixel.x + pixel.y + pixel.z + pixel.w); }
bool finite(float pixel) { return std::isfinite(pixel); }

/// One or several adjacent lines of pixels. Solves the tridiagonal system (1 + flow) u = c for each. The flow between
/// neighbors is symmetric, so that the sum of the colors is preserved.
template <std::size_t lanes, typename Pixel>
struct Line {
    Pixel* pixel;
    const float* conductivity;  // per pixel; between two pixels the minimum
    std::size_t count, stride;

    float between(std::size_t i, std::size_t lane) const {
        const std::size_t at = i * stride + lane;
        return std::min(conductivity[at], conductivity[at + stride]);
    }

    /// `onward`: scratch space for lanes * count numbers.
    void solve(float* onward) const {
        float flow[lanes] = {};  // conductivity to the pixel before
        for (std::size_t i = 0; i < count; ++i) {
            Pixel* here = pixel + i * stride;
            for (std::size_t lane = 0; lane < lanes; ++lane) {
                const float before = flow[lane], after = i + 1 < count ? between(i, lane) : 0.0f;
                const float back = i ? onward[(i - 1) * lanes + lane] : 0.0f;
                const float scale = 1.0f / (1.0f + after + before * (1.0f - back));
                onward[i * lanes + lane] = after * scale;
                if (before > 0.0f)
                    here[lane] = (here[lane] + before * *(here + lane - stride)) * scale;
                else if (after > 0.0f)
                    here[lane] *= scale;
                flow[lane] = after;
            }
        }
        for (std::size_t i = count - 1; i-- > 0;) {
            Pixel* here = pixel + i * stride;
            for (std::size_t lane = 0; lane < lanes; ++lane) {
                const float share = onward[i * lanes + lane];
                if (share > 0.0f) here[lane] += share * here[lane + stride];
            }
        }
    }
};

template <typename Pixel>
void along_rows(std::span<Pixel> image, std::size_t width, const Array<float>& conductivity) {
    parallel_blocks(image.size() / width, 8, [&](std::size_t, std::size_t begin, std::size_t end) {
        Array<float> onward(width);
        for (std::size_t y = begin; y < end; ++y)
            Line<1, Pixel>{&image[y * width], &conductivity[y * width], width, 1}.solve(onward.data());
    });
}

template <typename Pixel>
void along_columns(std::span<Pixel> image, std::size_t width, const Array<float>& conductivity) {
    const std::size_t height = image.size() / width;
    parallel_blocks(width, side_by_side, [&](std::size_t, std::size_t begin, std::size_t end) {
        Array<float> onward(height * side_by_side);
        if (end - begin == side_by_side)
            Line<side_by_side, Pixel>{&image[begin], &conductivity[begin], height, width}.solve(onward.data());
        else
            for (std::size_t x = begin; x < end; ++x)
                Line<1, Pixel>{&image[x], &conductivity[x], height, width}.solve(onward.data());
    });
}

template <typename Pixel>
void diffuse(std::span<Pixel> image, int width, In<float> radius_px) {
    check(radius_px.size() == image.size(), "blur: expected one radius per pixel");
    check(width > 0 && image.size() % std::size_t(width) == 0, "blur: the image is no rectangle");
    // A disc of radius r has variance r^2 / 4 along an axis, one solution twice its conductivity.
    Array<float> conductivity(image.size());
    std::atomic<bool> any{false};
    parallel_blocks(image.size(), 1 << 15, [&](std::size_t, std::size_t begin, std::size_t end) {
        bool here = false;
        for (std::size_t i = begin; i < end; ++i) {
            const float radius = radius_px[i] > 0.0f ? std::min(radius_px[i], most_px) : 0.0f;
            conductivity[i] = radius > 0.0f && finite(image[i]) ? radius * radius / float(8 * rounds) : 0.0f;
            here |= conductivity[i] > 0.0f;
        }
        if (here) any = true;
    });
    if (!any) return;
    for (int i = 0; i < rounds; ++i) {
        along_rows(image, std::size_t(width), conductivity);
        along_columns(image, std::size_t(width), conductivity);
    }
}

}  // namespace

void blur(std::span<vec4> image, int width, In<float> radius_px) { diffuse(image, width, radius_px); }

void blur(std::span<float> image, int width, In<float> radius_px) { diffuse(image, width, radius_px); }

}  // namespace fovea::color
