// SPDX-License-Identifier: GPL-3.0-or-later
#include <fovea/color/shadows.h>

#include <algorithm>
#include <bit>

#include <fovea/base/parallel.h>
#include <fovea/image/lattice.h>

namespace fovea::color {
namespace {

LightBits of_part(std::size_t light) { return LightBits(1u << light); }
LightBits of_middle(std::size_t light) { return LightBits(1u << (most_casters + light)); }

/// One of `parts` of a light, evenly over [-1, 1]^2.
dvec2 part_of(int part, int parts) { return 2.0 * place_in_square(part, std::countr_zero(unsigned(parts))); }

/// Around a light: corners, then the middles between them.
constexpr dvec2 rim_of_light[] = {{-1, -1}, {1, 1}, {-1, 1}, {1, -1}, {0, -1}, {0, 1}, {-1, 0}, {1, 0}};

/// Along one axis: `step` apart.
KnownLights around(const KnownLights* known, int at, int count, std::ptrdiff_t step) {
    KnownLights all;
    const int first = std::max(at - around_px / 2, 0), last = std::min(at + around_px / 2, count - 1);
    for (int i = first; i <= last; ++i) all |= known[(i - at) * step];
    return all;
}

}  // namespace

Shadows::Shadows(const Tracer& tracer, std::vector<Light> casters, const style::Color& style)
    : view_to_world_(glm::inverse(tracer.view().world_to_view)),
      world_to_view_(tracer.view().world_to_view),
      strength_(float(style.shadow)),
      blacks_(style.blacks > 0.0),
      shades_(tracer.scene(), std::move(casters)),
      surfaces_(tracer.scene().placements.size()) {
    const dvec4 viewer = view_to_world_ * (tracer.view().orthographic ? dvec4(0, 0, 1, 0) : dvec4(0, 0, 0, 1));
    parallel_for(surfaces_.size(), 1, [&](std::size_t i) {
        if (in_frame(tracer.scene().placements[i], tracer.view(), 0.1))
            surfaces_[i] = std::make_unique<const scene::ShadedSurface>(tracer.scene(), Index(i), viewer);
    });
}

vec3 Shadows::smooth_normal(const ShadedPlace& place) const {
    // Places of smooth surfaces are on triangles, others on facets.
    return place.ignore.across_triangles() ? vec3(world_to_view_ * place.normal) : vec3(0.0f);
}

ShadedPlace Shadows::place(Index placement, Index triangle, const dvec3& point) const {
    return surfaces_[placement]->at(triangle, dvec3(view_to_world_ * dvec4(point, 1.0)));
}

KnownLights Shadows::sampled(const ShadedPlace& place, int x, int y) const {
    constexpr int side = around_px / first_px;
    const dvec2 part = part_of(x / first_px % side + side * (y / first_px % side), few_parts);
    KnownLights known;
    for (std::size_t i = 0; i < shades_.count(); ++i) {
        const bool parted = strength_ > 0.0f && shades_.has_size(i);
        const bool middle = !parted || blacks_ ? shades_.by(i, place) == Shade::lit : false;
        const bool lit = parted ? shades_.by_part(i, place, part) == Shade::lit : middle;
        (lit ? known.lit : known.dark) |= of_part(i);
        if (blacks_) (middle ? known.lit : known.dark) |= of_middle(i);
    }
    return known;
}

float Shadows::share(std::size_t light, const ShadedPlace& place, int parts) const {
    const auto is_lit = [&](const dvec2& part) { return shades_.by_part(light, place, part) == Shade::lit; };
    if (!shades_.has_size(light)) return is_lit(dvec2(0.0)) ? 1.0f : 0.0f;
    // Where its rim and some more are lit, or dark, all of it is: so most places near penumbras need few rays.
    const int some = parts / 4, rim = parts == all_parts ? 8 : 4;
    int lit = 0, looked = 0;
    for (; looked < rim + some && (lit == 0 || lit == looked); ++looked)
        lit += is_lit(looked < rim ? rim_of_light[looked] : part_of(looked - rim, some));
    if (lit == 0 || lit == looked) return lit ? 1.0f : 0.0f;
    lit = 0;
    for (int i = 0; i < parts; ++i) lit += is_lit(part_of(i, parts));
    return float(lit) / float(parts);
}

void Shadows::leave(const ShadedPlace& place, const KnownLights& around, int parts, Reach& reach) const {
    if (!(strength_ > 0.0f)) return;
    for (std::size_t i = 0; i < shades_.count(); ++i) {
        const LightBits bit = of_part(i);
        const float lit = around.is_open(bit) ? share(i, place, parts) : float((around.lit & bit) != 0);
        reach.left[i] = 1.0f - strength_ * (1.0f - lit);
    }
}

void Shadows::see_middles(const ShadedPlace& place, const KnownLights& around, Reach& reach) const {
    for (std::size_t i = 0; i < shades_.count(); ++i) {
        const LightBits bit = of_middle(i);
        const bool lit = around.is_open(bit) ? shades_.by(i, place) == Shade::lit : (around.lit & bit) != 0;
        reach.middle[i] = lit ? 1.0f : 0.0f;
    }
}

Array<KnownLights> known_around(const Array<KnownLights>& known, int width) {
    const int height = int(known.size() / std::size_t(width));
    Array<KnownLights> along(known.size()), all(known.size());
    parallel_for(height, 16, [&](std::size_t y) {
        for (int x = 0; x < width; ++x) along[y * width + x] = around(&known[y * width + x], x, width, 1);
    });
    parallel_for(height, 16, [&](std::size_t y) {
        for (int x = 0; x < width; ++x) all[y * width + x] = around(&along[y * width + x], int(y), height, width);
    });
    return all;
}

}  // namespace fovea::color
