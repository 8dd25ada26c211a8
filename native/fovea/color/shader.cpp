// SPDX-License-Identifier: GPL-3.0-or-later
#include <fovea/color/shader.h>

#include <algorithm>
#include <cmath>

#include <fovea/base/check.h>
#include <fovea/base/parallel.h>
#include <fovea/mesh/corners.h>

namespace fovea::color {
namespace {

/// Normalizes barycentrics, clamped in case rounding put them slightly outside.
vec3 normalized(const dvec3& share) {
    const dvec3 inside = glm::max(share, dvec3(0.0));
    const double sum = inside.x + inside.y + inside.z;
    return sum > 0.0 ? vec3(inside / sum) : vec3(1.0f / 3.0f);
}

template <typename T>
T mixed(const Array<T>& values, const std::array<Index, 3>& at, const vec3& share) {
    return values[at[0]] * share.x + values[at[1]] * share.y + values[at[2]] * share.z;
}

const ColorSlot default_slot;

bool is_direction(const vec3& v) {
    const float length = glm::length(v);
    return length > 0.0f && std::isfinite(length);
}

/// Bound of colors, so that sums and products of them are finite, too.
constexpr float brightest = 1e6f;

/// NaN is black, as in textures.
vec3 bounded(const vec3& color) {
    const auto channel = [](float c) { return std::isnan(c) ? 0.0f : std::clamp(c, -brightest, brightest); };
    return {channel(color.r), channel(color.g), channel(color.b)};
}

}  // namespace

ColorShader::ColorShader(const Scene& scene, const View& view, const SceneColor& colors, const Lighting& lighting,
                         bool with_normals)
    : scene_(scene),
      view_(view),
      colors_(colors),
      lighting_(lighting),
      pixel_to_ray_(pixel_to_ray(view)),
      placed_(scene.placements.size()) {
    check(colors.size() == scene.placements.size(), "colors: one entry per placement expected");
    parallel_for(placed_.size(), 1, [&](std::size_t i) {
        const Placement& placement = scene.placements[i];
        if (colors[i]) check_color(*colors[i], *placement.surface);
        placed_[i].object_to_view = view.world_to_view * placement.object_to_world;
        placed_[i].normal_to_view = glm::mat3(glm::transpose(glm::inverse(dmat3(placed_[i].object_to_view))));
        const bool brings_normals = colors[i] && !colors[i]->normals.empty();
        if ((with_normals || lighting.shading() != Shading::flat) && !brings_normals && in_frame(placement, view, 0.0))
            placed_[i].normals = corner_normals(*placement.surface);
    });
}

SeenTriangle ColorShader::triangle(Index placement, Index triangle) const {
    const Surface& surface = *scene_.placements[placement].surface;
    const Triangle& t = surface.triangles[triangle];
    dvec3 corner[3];
    for (int k = 0; k < 3; ++k)
        corner[k] = dvec3(placed_[placement].object_to_view * dvec4(dvec3(surface.positions[t[k]]), 1.0));
    SeenTriangle seen;
    seen.screen = ScreenTriangle(corner, pixel_to_ray_, view_.orthographic);
    seen.placement = placement;
    seen.triangle = triangle;
    const Index polygon = surface.facet_polygon[surface.triangle_facet[triangle]];
    seen.corner = triangle_corners(surface, triangle);
    const SurfaceColor* own = colors_[placement].get();
    const auto slot = static_cast<std::size_t>(surface.polygon_material[polygon]);
    seen.slot = own && slot < own->slots.size() ? &own->slots[slot] : &default_slot;
    return seen;
}

dvec3 ColorShader::point(const SeenTriangle& triangle, const dvec2& px, const dvec3& share) const {
    const dvec3 ray = pixel_to_ray_ * dvec3(px, 1.0);
    const double distance = triangle.screen.distance(share);
    return view_.orthographic ? dvec3(ray.x, ray.y, -distance) : ray * distance;
}

template <typename Use>
auto ColorShader::lit(const SeenTriangle& triangle, const dvec2& px, const dvec3& share, const Use& use) const {
    const vec3 to_eye = view_.orthographic ? vec3(0, 0, 1) : vec3(glm::normalize(-(pixel_to_ray_ * dvec3(px, 1.0))));
    return use(point(triangle, px, share), normal(triangle, normalized(share), to_eye), to_eye);
}

vec3 ColorShader::color(const SeenTriangle& triangle, const dvec2& px, const dvec3& share, const Reach* reach) const {
    const vec3 color = bounded(base(triangle, px, normalized(share)));
    if ((lighting_.shading() == Shading::flat && !reach) || triangle.slot->unlit) return color;
    return lit(triangle, px, share,
               [&](const auto&... where) { return bounded(color * lighting_.at(where..., reach)); });
}

float ColorShader::tone(const SeenTriangle& triangle, const dvec2& px, const dvec3& share, const Reach& reach) const {
    if (triangle.slot->unlit) return 1.0f;
    return lit(triangle, px, share, [&](const auto&... where) { return lighting_.tone(where..., reach); });
}

int ColorShader::band(const SeenTriangle& triangle, const dvec2& px, const dvec3& share) const {
    if (lighting_.shading() != Shading::toon || triangle.slot->unlit) return 0;
    return lit(triangle, px, share, [&](const auto&... where) { return lighting_.band(where...); });
}

vec3 ColorShader::base(const SeenTriangle& triangle, const dvec2& px, const vec3& share) const {
    const ColorSlot& slot = *triangle.slot;
    vec3 color = slot.color;
    if (slot.attribute != none)
        color *= mixed(colors_[triangle.placement]->attributes[slot.attribute], triangle.corner, share);
    if (slot.texture && slot.uv != none) {
        const Array<vec2>& uvs = colors_[triangle.placement]->uvs[slot.uv];
        const vec2 here = mixed(uvs, triangle.corner, share);
        const auto step = [&](double x, double y) {
            const dvec3 there = triangle.screen.at(px + dvec2(x, y));
            const vec2 moved = mixed(uvs, triangle.corner, vec3(there / (there.x + there.y + there.z))) - here;
            return glm::length(moved);
        };
        const float right = step(1.0, 0.0), up = step(0.0, 1.0);
        const float longer = std::max(right, up), shorter = std::min(right, up);
        // Footprint between the longer and the shorter axis: at grazing angles a compromise between blur and aliasing.
        color *= slot.texture->at(here, std::max(std::sqrt(longer * shorter), 0.25f * longer));
    }
    return color;
}

vec3 ColorShader::normal(const SeenTriangle& triangle, const vec3& share, const vec3& to_eye) const {
    const Surface& surface = *scene_.placements[triangle.placement].surface;
    const Placed& placed = placed_[triangle.placement];
    const vec3 across = placed.normal_to_view * vec3(surface.facet_plane[surface.triangle_facet[triangle.triangle]]);
    // A placement without volume gives no direction.
    const vec3 facet = is_direction(across) ? across : to_eye;
    vec3 found(0.0f);
    if (placed.normals) {
        for (int k = 0; k < 3; ++k)
            found += share[k] * placed.normals->at(surface.triangles[triangle.triangle], triangle.triangle, k);
    } else {
        found = mixed(colors_[triangle.placement]->normals, triangle.corner, share);
    }
    found = placed.normal_to_view * found;
    found = is_direction(found) ? found / glm::length(found) : glm::normalize(facet);
    return glm::dot(facet, to_eye) < 0.0f ? -found : found;
}

}  // namespace fovea::color
