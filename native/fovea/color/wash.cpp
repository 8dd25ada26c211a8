// SPDX-License-Identifier: GPL-3.0-or-later
#include <fovea/color/wash.h>

#include <algorithm>
#include <cmath>

#include <fovea/base/check.h>
#include <fovea/base/elementary.h>
#include <fovea/base/parallel.h>
#include <fovea/color/effects.h>

namespace fovea::color {
namespace {

/// Width along borders that the pigment leaves, mm.
constexpr double edge_mm = 0.8;
/// Excess of density over the mean around it with which an edge is as dark as it becomes. On a straight border with
/// bare paper it is half.
constexpr float full_excess = 0.5f;
/// Least transmittance that counts as another.
constexpr float darkest = 1e-3f;

/// Optical density of each pixel, the sum over red, green and blue.
Array<float> densities(In<vec4> layer, const vec3& ground, float opacity) {
    Array<float> result(layer.size());
    parallel_for(layer.size(), [&](std::size_t i) {
        const vec4 over = layer[i] * opacity;
        const vec3 seen = vec3(over) + ground * (1.0f - over.a);
        float through = 1.0f;
        for (int c = 0; c < 3; ++c) through *= std::clamp(seen[c] / std::max(ground[c], darkest), darkest, 1.0f);
        result[i] = -logarithm(through);
    });
    return result;
}

}  // namespace

Array<float> wash_density(In<vec4> layer, const View& view, const PaperTexture* water, const style::Paper& paper,
                          const style::Color& color) {
    const float edges = float(color.edge_darkening), runs = water ? float(color.backruns) : 0.0f;
    if (layer.empty() || (edges <= 0.0f && runs <= 0.0f)) return {};
    const auto width = static_cast<std::size_t>(view.width);
    check(layer.size() == width * std::size_t(view.height), "layer: expected one entry per pixel of the view");
    Array<float> factor(layer.size(), 1.0f);
    if (edges > 0.0f) {
        const Array<float> own = densities(layer, vec3(color.background.value_or(paper.color)), float(color.opacity));
        Array<float> around = own;
        const double radius_px = edge_mm * paper.px_per_mm(view.reference_scale);
        blur(around, view.width, Array<float>(around.size(), float(radius_px)));
        parallel_for(factor.size(), [&](std::size_t i) {
            const float excess = own[i] > 0.0f ? 1.0f - around[i] / own[i] : 0.0f;
            factor[i] += edges * std::clamp(excess / full_excess, 0.0f, 1.0f);
        });
    }
    if (runs > 0.0f) {
        const PlacesUnder places(water, 1.0, paper, view);
        parallel_blocks(factor.size(), width, [&](std::size_t y, std::size_t begin, std::size_t end) {
            for (std::size_t i = begin; i < end; ++i) {
                float lower = 0.0f;
                places.pixel(vec2(float(i - begin), float(y)),
                             [&](const PaperPlace& place, float share) { lower += share * place.lower; });
                factor[i] *= 1.0f + runs * (1.0f - 2.0f * lower);
            }
        });
    }
    return factor;
}

}  // namespace fovea::color
