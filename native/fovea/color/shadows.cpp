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

/// One of the four parts of one of 16 samples: in each quadrant one, and of all samples 64 that are even, too. Which
/// sample has which is as if by chance, since samples are even over the pixel in the same order.
dvec2 part_of_sample(int part, int sample) {
    const int group = (7 * sample + 3) % 16;
    return part_of((part & 2) << 4 | group << 1 | (part & 1), all_parts.count);
}

/// Around a light: corners, then the middles between them.
constexpr dvec2 rim_of_light[] = {{-1, -1}, {1, 1}, {-1, 1}, {1, -1}, {0, -1}, {0, 1}, {-1, 0}, {1, 0}};

/// Which of 16 parts a pixel takes: in any aligned square of 4 x 4 pixels all, and so do those with even coordinates in
/// one of 8 x 8.
int part_at(int x, int y) {
    const auto in_two = [](int u, int v) { return u % 2 + 2 * (v % 2); };
    static_assert(first_px == 2 && around_px == 4);
    return 4 * ((in_two(x, y) + in_two(x / 4, y / 4)) % 4) + in_two(x / 2, y / 2);
}

/// Along one axis: `step` apart.
KnownLights around(const KnownLights* known, int at, int count, std::ptrdiff_t step, int px) {
    KnownLights all;
    const int first = std::max(at - px, 0), last = std::min(at + px, count - 1);
    for (int i = first; i <= last; ++i) all |= known[(i - at) * step];
    return all;
}

}  // namespace

Shadows::Shadows(const Tracer& tracer, std::vector<Light> casters, const style::Color& style)
    : view_to_world_(glm::inverse(tracer.view().world_to_view)),
      world_to_view_(tracer.view().world_to_view),
      strength_(float(style.shadow)),
      shades_(tracer.scene(), std::move(casters)),
      surfaces_(tracer.scene().placements.size()) {
    for (std::size_t i = 0; i < shades_.count(); ++i)
        asked_ |= LightBits((strength_ > 0.0f ? of_part(i) : 0) | (style.blacks > 0.0 ? of_middle(i) : 0));
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

KnownLights Shadows::sampled(const ShadedPlace& place, int x, int y, const KnownLights& around) const {
    const dvec2 part = part_of(part_at(x, y), few_parts.count);
    KnownLights known;
    const auto tell = [&](LightBits bit, const auto& is_lit) {
        if (!(asked_ & bit)) return;
        const bool lit = around.open(bit) ? is_lit() : (around.lit & bit) != 0;
        (lit ? known.lit : known.dark) |= bit;
    };
    for (std::size_t i = 0; i < shades_.count(); ++i) {
        const scene::PlaceByLight seen(shades_, i, place);
        tell(of_part(i), [&] { return seen.by_part(part) == Shade::lit; });
        tell(of_middle(i), [&] { return seen.by_middle() == Shade::lit; });
    }
    return known;
}

float Shadows::share(std::size_t light, const ShadedPlace& place, const PartsOfLights& asked) const {
    const scene::PlaceByLight seen(shades_, light, place);
    const auto is_lit = [&](const dvec2& part) { return seen.by_part(part) == Shade::lit; };
    if (!shades_.has_size(light)) return is_lit(dvec2(0.0)) ? 1.0f : 0.0f;
    const int parts = asked.count;
    int lit = 0, looked = 0;
    if (asked.sample) {
        for (int i = 0; i < parts; ++i) lit += is_lit(part_of_sample(i, *asked.sample));
        return float(lit) / float(parts);
    }
    // Where its rim and some more are lit, or dark, all of it is: so most places near penumbras need few rays.
    const int some = parts / 4, rim = parts == all_parts.count ? 8 : 4;
    for (; looked < rim + some && (lit == 0 || lit == looked); ++looked)
        lit += is_lit(looked < rim ? rim_of_light[looked] : part_of(looked - rim, some));
    if (lit == 0 || lit == looked) return lit ? 1.0f : 0.0f;
    lit = 0;
    for (int i = 0; i < parts; ++i) lit += is_lit(part_of(i, parts));
    return float(lit) / float(parts);
}

void Shadows::leave(const ShadedPlace& place, const KnownLights& around, const PartsOfLights& parts,
                    Reach& reach) const {
    if (!(strength_ > 0.0f)) return;
    for (std::size_t i = 0; i < shades_.count(); ++i) {
        const LightBits bit = of_part(i);
        const float lit = around.open(bit) ? share(i, place, parts) : float((around.lit & bit) != 0);
        reach.left[i] = 1.0f - strength_ * (1.0f - lit);
    }
}

void Shadows::see_middles(const ShadedPlace& place, const KnownLights& around, Reach& reach) const {
    for (std::size_t i = 0; i < shades_.count(); ++i) {
        const LightBits bit = of_middle(i);
        const bool lit = around.open(bit) ? shades_.by(i, place) == Shade::lit : (around.lit & bit) != 0;
        reach.middle[i] = lit ? 1.0f : 0.0f;
    }
}

Array<KnownLights> known_around(const Array<KnownLights>& known, int width, int px) {
    const int height = int(known.size() / std::size_t(width));
    Array<KnownLights> along(known.size()), all(known.size());
    parallel_for(height, 16, [&](std::size_t y) {
        for (int x = 0; x < width; ++x) along[y * width + x] = around(&known[y * width + x], x, width, 1, px);
    });
    parallel_for(height, 16, [&](std::size_t y) {
        for (int x = 0; x < width; ++x) all[y * width + x] = around(&along[y * width + x], int(y), height, width, px);
    });
    return all;
}

}  // namespace fovea::color
