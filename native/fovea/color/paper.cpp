// SPDX-License-Identifier: GPL-3.0-or-later
#include <fovea/color/paper.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include <fovea/base/check.h>
#include <fovea/base/elementary.h>
#include <fovea/base/parallel.h>
#include <fovea/base/steps.h>

namespace fovea::color {
namespace {

/// Width of the ramp, in quantiles of height, over which ink runs out.
constexpr float soft = 0.25f;
/// Minimum transmittance of pigment.
constexpr float darkest = 1e-4f;
/// Maximum number of places of the paper looked at along a pixel.
constexpr int most_places = 8;

/// Quantile of each value: the fraction of all values that are lower; ties get the middle of their range; NaN is the
/// lowest.
Array<float> shares_lower(In<float> values) {
    Array<Index> order(values.size());
    std::iota(order.begin(), order.end(), Index(0));
    const auto key = [&](Index i) { return std::isnan(values[i]) ? -HUGE_VALF : values[i]; };
    std::stable_sort(order.begin(), order.end(), [&](Index a, Index b) { return key(a) < key(b); });
    Array<float> shares(values.size());
    const auto count = static_cast<float>(order.size());
    for (std::size_t begin = 0, end = 0; begin < order.size(); begin = end) {
        while (end < order.size() && key(order[end]) == key(order[begin])) ++end;
        for (std::size_t i = begin; i < end; ++i) shares[order[i]] = 0.5f * float(begin + end) / count;
    }
    return shares;
}

/// How much light each texel gets: more where it faces that at the upper left, and where it stands out from the texels
/// around it, since light comes from all around, too: slopes alone look like streaks across the light. Wraps around at
/// the borders.
Array<float> light(In<float> heights, int width, int height) {
    constexpr float all_around = 1.5f;
    Array<float> result(heights.size());
    for (int y = 0; y < height; ++y) {
        const int rows[] = {(y + height - 1) % height, y, (y + 1) % height};
        for (int x = 0; x < width; ++x) {
            const int columns[] = {(x + width - 1) % width, x, (x + 1) % width};
            const auto at = [&](int column, int row) {
                return heights[std::size_t(rows[row]) * width + columns[column]];
            };
            float sum = 0.0f;
            for (int row = 0; row < 3; ++row)
                for (int column = 0; column < 3; ++column) sum += at(column, row);
            result[std::size_t(y) * width + x] = at(2, 0) - at(0, 2) + all_around * (at(1, 1) - sum / 9.0f);
        }
    }
    return result;
}

int wrapped(float i, int size) {
    const float turns = std::floor(i / float(size));
    return std::clamp(int(i - turns * float(size)), 0, size - 1);
}

/// Pixel position of the view's axis.
vec2 origin_of(const View& view) {
    const dvec2 px = to_pixels(view, view.view_to_clip * dvec4(0.0, 0.0, -1.0, 1.0));
    return std::isfinite(px.x) && std::isfinite(px.y) ? vec2(px) : vec2(0.0f);
}

/// Color of pigment that looks like `seen` on `under`, with its optical density scaled by `share`.
vec3 granulated(const vec3& seen, const vec3& under, float share) {
    vec3 result;
    for (int c = 0; c < 3; ++c) {
        const float through = std::max(seen[c], 0.0f) / std::max(under[c], darkest);
        result[c] = std::max(under[c], darkest) * float(power(std::max(through, darkest), share));
    }
    return result;
}

}  // namespace

PaperTexture::PaperTexture(In<float> heights, int w, int h, double mm)
    : width(w), height(h), tile_mm(mm), places(heights.size()) {
    check(w > 0 && h > 0 && heights.size() == std::size_t(w) * h, "paper: the number of heights is not its size");
    check(mm > 0.0, "paper: a tile must be larger than nothing");
    const Array<float> lower = shares_lower(heights), lit = shares_lower(light(heights, w, h));
    for (std::size_t i = 0; i < places.size(); ++i) places[i] = {lower[i], lit[i]};
}

PaperPlace PaperTexture::at(const vec2& texel) const {
    const vec2 at = texel - 0.5f, low = glm::floor(at), share = at - low;
    const int x0 = wrapped(low.x, width), x1 = x0 + 1 == width ? 0 : x0 + 1;
    const int y0 = wrapped(low.y, height), y1 = y0 + 1 == height ? 0 : y0 + 1;
    const auto place_at = [&](int x, int y) {
        const PaperPlace& place = places[std::size_t(y) * width + x];
        return vec2(place.lower, place.lit);
    };
    const vec2 mean = glm::mix(glm::mix(place_at(x0, y0), place_at(x1, y0), share.x),
                               glm::mix(place_at(x0, y1), place_at(x1, y1), share.x), share.y);
    return {mean.x, mean.y};
}

PlacesUnder::PlacesUnder(const PaperTexture* texture, double scale, const style::Paper& paper, const View& view)
    : texture_(texture), origin_(origin_of(view)) {
    if (!texture) return;
    texel_px_ = float(texture->tile_mm / texture->width * scale * paper.px_per_mm(view.reference_scale));
    check(texel_px_ > 0.0f, "paper: a texel must cover more than nothing");
    along_ = steps_of(1.0f / texel_px_ - 0.01f, most_places);
}

float toothed(float opacity, float lower, float tooth) {
    if (!(opacity > 0.0f) || opacity >= 1.0f || tooth <= 0.0f) return opacity;
    // Position of the ramp for which the mean over all heights is the opacity; the ramp may be cut off at either end of
    // the range.
    float reach;
    if (opacity < 0.5f * soft)
        reach = std::sqrt(2.0f * soft * opacity);
    else if (opacity <= 1.0f - 0.5f * soft)
        reach = opacity + 0.5f * soft;
    else
        reach = 1.0f + soft - std::sqrt(2.0f * soft * (1.0f - opacity));
    const float covered = std::clamp((reach - (1.0f - lower)) / soft, 0.0f, 1.0f);
    return opacity + tooth * (covered - opacity);
}

void on_paper(In<vec4> lines, In<vec4> layer, In<float> density, In<float> holdout, const View& view,
              const PaperTexture* texture, const style::Paper& paper, const style::Color& color, Array<vec4>& out) {
    const auto width = static_cast<std::size_t>(view.width), count = width * std::size_t(view.height);
    check(lines.size() == count, "lines: expected one entry per pixel of the view");
    check(layer.empty() || layer.size() == count, "layer: expected one entry per pixel of the view");
    check(density.empty() || density.size() == count, "density: expected one value per pixel of the view");
    check(holdout.empty() || holdout.size() == count, "holdout: expected one value per pixel of the view");
    out.resize(count);
    const PlacesUnder places(texture, paper.scale, paper, view);
    const float granulation = texture && !paper.transparent ? float(paper.granulation) : 0.0f;
    const vec3 ground(layer.empty() ? paper.color : color.background.value_or(paper.color));
    const float layer_opacity = float(color.opacity), tooth = float(paper.tooth), tint = float(paper.tint);
    parallel_blocks(count, width, [&](std::size_t y, std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            vec4 line = lines[i];
            PaperPlace mean{0.0f, 0.0f};
            float covered = 0.0f;
            places.pixel(vec2(float(i - begin), float(y)), [&](const PaperPlace& place, float share) {
                mean = {mean.lower + share * place.lower, mean.lit + share * place.lit};
                covered += share * toothed(line.a, place.lower, tooth);
            });
            const float shade = 1.0f + tint * (2.0f * mean.lit - 1.0f);
            const float alpha = paper.transparent ? 0.0f : holdout.empty() ? 1.0f : 1.0f - holdout[i];
            vec4 pixel(ground * alpha, alpha);
            const vec4 over = layer.empty() ? vec4(0.0f) : layer[i] * layer_opacity;
            if (over.a > 0.0f) {
                pixel = over + pixel * (1.0f - over.a);
                const float share = (density.empty() ? 1.0f : density[i]) + granulation * (1.0f - 2.0f * mean.lower);
                if (share != 1.0f && pixel.a > 0.0f)
                    pixel = vec4(granulated(vec3(pixel) / pixel.a, ground, share) * pixel.a, pixel.a);
            }
            if (texture && tooth > 0.0f && line.a > 0.0f) line *= covered / line.a;
            pixel = line + pixel * (1.0f - line.a);
            out[i] = vec4(vec3(pixel) * shade, pixel.a);
        }
    });
}

}  // namespace fovea::color
