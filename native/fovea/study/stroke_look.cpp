// SPDX-License-Identifier: GPL-3.0-or-later
#include <fovea/study/stroke_look.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>

#include <fovea/base/check.h>
#include <fovea/base/parallel.h>
#include <fovea/study/darkness.h>
#include <fovea/study/line_direction.h>
#include <fovea/study/nearest_pixel.h>
#include <fovea/study/precision_recall.h>
#include <fovea/study/scan.h>

namespace fovea::study {
namespace {

constexpr int along = 8;             // [px] how far along a stroke its darkness is looked for
constexpr std::size_t darkest = 2;   // of the pixels there: the third one, in case of dust
constexpr int direction_within = 4;  // [px]
constexpr float wide = 3.0f;         // [px] from which on the middle of a stroke is ink throughout
constexpr float step = 0.25f;        // [px] across strokes
constexpr float widest = 0.1f;       // of the diagonal: half a stroke's width at most
constexpr float end = 0.06f,
                again = 0.15f;    // of a stroke's darkness: what is less is paper, what is more is another one
constexpr float border = 0.08f;   // of it: a pixel that is neither paper nor ink throughout is between
constexpr std::size_t bins = 50;  // of shares of ink at borders
constexpr double uneven = 0.3;    // shares at borders tell nothing: all lines lie alike on the pixels

/// How dark the stroke is at most, at each pixel of the lines.
Array<float> inks_of(const Darkness& dark, const Bitmap& lines, const Array<Index>& pixels) {
    const auto most_beside = [&](int x, int y) {
        float most = 0.0f;
        for (int dy = -1; dy <= 1; ++dy)
            for (int dx = -1; dx <= 1; ++dx) most = std::max(most, dark.at(x + dx, y + dy));
        return most;
    };
    Array<float> here(lines.set.size(), 0.0f);
    parallel_for(pixels.size(), 1024, [&](std::size_t i) {
        here[pixels[i]] = most_beside(int(pixels[i] % Index(lines.width)), int(pixels[i] / Index(lines.width)));
    });
    Array<float> inks(pixels.size());
    parallel_for(pixels.size(), 256, [&](std::size_t i) {
        const int x = int(pixels[i] % Index(lines.width)), y = int(pixels[i] / Index(lines.width));
        std::vector<float> near;
        for (int v = std::max(0, y - along); v <= std::min(lines.height - 1, y + along); ++v)
            for (int u = std::max(0, x - along); u <= std::min(lines.width - 1, x + along); ++u) {
                const std::size_t k = std::size_t(v) * std::size_t(lines.width) + std::size_t(u);
                if (lines.set[k]) near.push_back(here[k]);
            }
        const auto wanted = near.begin() + std::ptrdiff_t(std::min(darkest, near.size() - 1));
        std::nth_element(near.begin(), wanted, near.end(), std::greater<>());
        inks[i] = *wanted;
    });
    return inks;
}

/// How far pixels at the borders of strokes are from having all shares of the ink of the nearest stroke equally often:
/// the largest difference of both distributions, [0, 1].
double unevenness(const Darkness& dark, const Array<Index>& nearest, const Array<float>& ink_at) {
    std::array<double, bins> counts{};
    double count = 0.0;
    for (std::size_t i = 0; i < dark.values.size(); ++i) {
        const float share = (dark.values[i] / ink_at[nearest[i]] - border) / (1.0f - 2.0f * border);
        if (share > 0.0f && share < 1.0f) counts[std::size_t(share * float(bins))] += 1.0, count += 1.0;
    }
    double most = 0.0, below = 0.0;
    for (std::size_t k = 0; k < bins; ++k) {
        below += counts[k];
        most = std::max(most, std::abs(below / std::max(count, 1.0) - double(k + 1) / bins));
    }
    return most;
}

/// Ink from the middle of a stroke to one side: up to the paper, or to where another stroke begins.
float ink_to_a_side(const Darkness& dark, const vec2& from, const vec2& across, float ink, float reach) {
    float sum = 0.0f, least = ink, until_least = 0.0f, before = dark.at(from);
    for (float far = step; far <= reach; far += step) {
        const float now = dark.at(from + far * across);
        sum += 0.5f * step * (before + now);
        before = now;
        if (now <= least) least = now, until_least = sum;
        if (now <= end * ink) return sum;
        if (now > least + again * ink) break;
    }
    return until_least;
}

}  // namespace

StrokeLooks looks_of(const color::GrayImage& picture, const Bitmap& lines) {
    lines.check_size_of({picture.width, picture.height});
    const Array<Index> pixels = pixels_in(lines);
    StrokeLooks looks;
    if (pixels.empty()) return looks;
    const Array<Index> nearest = nearest_pixels(lines);
    const Darkness of_light = darkness_of(picture, true), of_values = darkness_of(picture, false);
    const Array<float> light_inks = inks_of(of_light, lines, pixels), value_inks = inks_of(of_values, lines, pixels);
    const auto uneven_by = [&](const Darkness& dark, const Array<float>& inks) {
        Array<float> ink_at(lines.set.size(), 1.0f);
        for (std::size_t i = 0; i < pixels.size(); ++i) ink_at[pixels[i]] = std::max(inks[i], 1e-3f);
        return unevenness(dark, nearest, ink_at);
    };
    const double by_light = uneven_by(of_light, light_inks), by_values = uneven_by(of_values, value_inks);
    const bool is_light = by_light < std::min(uneven, by_values);
    const Darkness& dark = is_light ? of_light : of_values;
    const Array<float>& inks = is_light ? light_inks : value_inks;
    const float reach = widest * float(lines.diagonal());
    const bool is_dark = paper_of(picture) < dark_paper;
    Array<float> widths(pixels.size(), 0.0f);
    parallel_for(pixels.size(), 256, [&](std::size_t i) {
        const int x = int(pixels[i] % Index(lines.width)), y = int(pixels[i] / Index(lines.width));
        const vec2 across = normal_at(lines, x, y, direction_within), from = vec2(float(x), float(y)) + 0.5f;
        if (across == vec2(0.0f) || inks[i] <= 0.0f) return;
        const auto to = [&](const vec2& side) { return ink_to_a_side(dark, from, side, inks[i], reach); };
        widths[i] = (to(across) + to(-across)) / inks[i];
    });
    for (std::size_t i = 0; i < pixels.size(); ++i)
        if (widths[i] > 0.0f) {
            looks.pixel.push_back(pixels[i]);
            looks.width.push_back(widths[i]);
            // Where strokes cross they are darker: what is nearby counts for narrow ones alone.
            const int x = int(pixels[i] % Index(lines.width)), y = int(pixels[i] / Index(lines.width));
            const float ink = widths[i] < wide ? light_inks[i] : of_light.at(x, y);
            looks.darkness.push_back(is_dark ? NAN : std::min(1.0f, ink));
        }
    return looks;
}

}  // namespace fovea::study
