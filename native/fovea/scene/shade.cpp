// SPDX-License-Identifier: GPL-3.0-or-later
#include <fovea/scene/shade.h>

#include <algorithm>
#include <cmath>
#include <glm/gtc/constants.hpp>

#include <fovea/base/elementary.h>
#include <fovea/base/parallel.h>
#include <fovea/field/shape.h>
#include <fovea/scene/light_view.h>

namespace fovea::scene {
namespace {

/// Sine of the height of a light above a surface up to which it is behind it: light along a wall does not light it.
/// More than light_view.h moves lights by.
constexpr double along_surface = 0x1p-20;

/// Weights of the triangle's corners at a point, clamped to the triangle.
dvec3 weights_at(const std::array<dvec3, 3>& corner, const dvec3& point) {
    const dvec3 normal = glm::cross(corner[1] - corner[0], corner[2] - corner[0]);
    const double twice = glm::dot(normal, normal);
    if (!(twice > 0.0)) return dvec3(1.0 / 3.0);
    dvec3 weights;
    for (int k = 0; k < 3; ++k) {
        const dvec3 side = corner[(k + 2) % 3] - corner[(k + 1) % 3];
        weights[k] = std::max(0.0, glm::dot(glm::cross(side, point - corner[(k + 1) % 3]), normal) / twice);
    }
    return weights / (weights.x + weights.y + weights.z);
}

/// How normals at the corners of a triangle turn along a way, into it: positive where the surface bends away from them.
double bend_along(const std::array<dvec3, 3>& corner, const std::array<dvec3, 3>& normal, const dvec3& way) {
    const dvec3 area = glm::cross(corner[1] - corner[0], corner[2] - corner[0]);
    dvec3 turn(0.0);
    for (int k = 0; k < 3; ++k)
        turn += glm::dot(glm::cross(corner[(k + 2) % 3] - corner[(k + 1) % 3], way), area) * normal[k];
    return glm::dot(turn, way);
}

/// The axis that is the most across a way.
dvec3 least_axis(const dvec3& way) {
    const dvec3 size = glm::abs(way);
    if (size.x <= size.y && size.x <= size.z) return {1, 0, 0};
    return size.y <= size.z ? dvec3(0, 1, 0) : dvec3(0, 0, 1);
}

/// The square [-1, 1]^2 taken into the unit disk. Shirley & Chiu, "A Low Distortion Map Between Disk and Square",
/// JGT 1997.
dvec2 in_disk(const dvec2& square) {
    const bool flat = std::abs(square.x) > std::abs(square.y);
    const double radius = flat ? square.x : square.y, other = flat ? square.y : square.x;
    if (radius == 0.0) return dvec2(0.0);
    const double angle = glm::quarter_pi<double>() * other / radius;
    const dvec2 turned = radius * dvec2(base::cosine(angle), base::sine(angle));
    return flat ? turned : dvec2(turned.y, turned.x);
}

}  // namespace

ShadedSurface::ShadedSurface(const Scene& scene, Index placement, const dvec4& viewer)
    : surface_(scene.placements[placement].surface.get()),
      placement_(placement),
      to_world_(scene.placements[placement].object_to_world),
      normals_to_world_(glm::transpose(glm::inverse(dmat3(to_world_)))),
      viewer_(viewer),
      viewer_obj_(glm::inverse(to_world_) * viewer),
      bodies_(bodies_of(*surface_)) {
    const dvec3 center(surface_->center);
    const double scale = std::max({glm::length(to_world_[0]), glm::length(to_world_[1]), glm::length(to_world_[2])});
    lift_ = 0x1p-19 * scale * (glm::length(center) + double(surface_->radius));
    if (field::shape_of(*surface_) == Shape::smooth) smooth_ = field::corner_normals(*surface_);
}

bool ShadedSurface::is_solid(Index facet) const {
    const Index body = bodies_->of_facet[facet];
    return body != none && bodies_->solid[body];
}

/// Whether the side that is looked at is that of the facet's back.
bool ShadedSurface::is_turned(Index facet) const {
    if (is_solid(facet)) return !bodies_->outward[bodies_->of_facet[facet]];
    const vec4& plane = surface_->facet_plane[facet];
    return glm::dot(dvec4(plane.x, plane.y, plane.z, -plane.w), viewer_obj_) < 0.0;
}

dvec3 ShadedSurface::facet_normal(Index facet) const {
    // The plane's normal is that of the winding in object space, and so is what its inverse transpose makes of it.
    const dvec3 normal = unit_or_zero(normals_to_world_ * dvec3(surface_->facet_plane[facet]));
    return is_turned(facet) ? -normal : normal;
}

bool ShadedSurface::faces_viewer(Index facet) const {
    const vec4& plane = surface_->facet_plane[facet];
    const bool front = glm::dot(dvec4(plane.x, plane.y, plane.z, -plane.w), viewer_obj_) >= 0.0;
    return front != is_turned(facet);
}

ShadedPlace ShadedSurface::at(Index triangle, const dvec3& point, bool contour) const {
    const Index facet = surface_->triangle_facet[triangle];
    const dvec3 flat = facet_normal(facet);
    if (!smooth_) return {point + lift_ * flat, flat, {.placement = placement_, .facet = facet}};
    const Triangle& vertices = surface_->triangles[triangle];
    std::array<dvec3, 3> corner, normal;
    for (int k = 0; k < 3; ++k) {
        corner[k] = dvec3(to_world_ * dvec4(dvec3(surface_->positions[vertices[k]]), 1.0));
        normal[k] = unit_or_zero(normals_to_world_ * dvec3(smooth_->at(vertices, triangle, k)));
    }
    const bool bends = contour && !is_solid(facet);
    const dvec3 to_viewer = viewer_.w == 0.0 ? dvec3(viewer_) : dvec3(viewer_) / viewer_.w - point;
    if (bends ? bend_along(corner, normal, to_viewer) < 0.0 : is_turned(facet))
        for (dvec3& n : normal) n = -n;
    const dvec3 weights = weights_at(corner, point);
    dvec3 mean(0.0);
    double height = 0.0;
    for (int k = 0; k < 3; ++k) {
        mean += weights[k] * normal[k];
        // Above a sphere this is twice the height of the sphere above its triangles.
        height += weights[k] * glm::dot(normal[k], corner[k] - point);
    }
    mean = unit_or_zero(mean);
    return {point + (lift_ + std::max(height, 0.0)) * mean, mean, {.placement = placement_, .around = vertices}};
}

Shades::Shades(const Scene& scene, std::size_t most) : Shades(scene, casting_lights(scene, most, false)) {}

Shades::Shades(const Scene& scene, std::vector<Light> lights)
    : lights_(std::move(lights)), last_(std::vector<Blocker>(lights_.size())) {
    for (const Light& light : lights_)
        tracers_.push_back(std::make_unique<const Tracer>(scene, view_from(light, scene)));
}

bool Shades::has_size(std::size_t number) const {
    const Light& light = lights_[number];
    if (light.kind != Light::area) return light.radius > 0.0 && std::isfinite(light.radius);
    return light.half_side[0] != dvec3(0.0) || light.half_side[1] != dvec3(0.0);
}

Shade Shades::by(std::size_t number, const ShadedPlace& place) const {
    return PlaceByLight(*this, number, place).by_middle();
}

PlaceByLight::PlaceByLight(const Shades& shades, std::size_t light, const ShadedPlace& place)
    : light_(shades.lights_[light]), tracer_(*shades.tracers_[light]), place_(place) {
    last_ = &shades.last_.local()[light];
    const dmat4& to_light = tracer_.view().world_to_view;
    const dmat3 turn(to_light);
    seen_ = dvec3(to_light * dvec4(place.point, 1.0));
    normal_ = turn * place.normal;
    if (!shades.has_size(light)) return;
    if (light_.kind == Light::area) {
        for (const int k : {0, 1}) across_[k] = turn * light_.half_side[k];
    } else if (tracer_.view().orthographic) {
        for (const int k : {0, 1}) across_[k][k] = light_.radius;
    } else {
        const dvec3 way = unit_or_zero(seen_);
        across_[0] = light_.radius * unit_or_zero(glm::cross(way, least_axis(way)));
        across_[1] = glm::cross(across_[0], way);
    }
}

Shade PlaceByLight::by_part(const dvec2& part) const {
    if (across_[0] == dvec3(0.0) && across_[1] == dvec3(0.0)) return by_middle();
    const dvec2 share = light_.kind == Light::area ? part : in_disk(part);
    return by(share.x * across_[0] + share.y * across_[1]);
}

Shade PlaceByLight::by(const dvec3& moved) const {
    const bool of_sun = tracer_.view().orthographic;
    const dvec3 sun = glm::normalize(dvec3(0, 0, 1) + moved), from_light = of_sun ? -sun : seen_ - moved;
    const double distance = of_sun ? 1.0 : glm::length(from_light);
    if (!std::isfinite(distance + glm::length(seen_))) return Shade::cast;
    if (normal_ != dvec3(0.0)) {
        const dvec3 towards = of_sun ? sun : -from_light / std::max(distance, 1e-300);
        if (glm::dot(normal_, towards) <= along_surface) return Shade::attached;
    }
    const double cone = cone_of(light_);
    if (cone > -1.0 && glm::dot(from_light, light_.direction) < cone * distance) return Shade::cast;
    // What is on no facet may lie on others.
    const double before = normal_ == dvec3(0.0) ? 1.0 - ray_margin : 1.0;
    const dvec3 origin = of_sun ? seen_ - seen_.z / sun.z * sun : moved;
    return tracer_.is_blocked(origin, seen_, before, place_.ignore, *last_) ? Shade::cast : Shade::lit;
}

Shade Shades::at(const ShadedPlace& place) const {
    Shade all = lights_.empty() ? Shade::lit : Shade::attached;
    for (std::size_t i = 0; i < lights_.size(); ++i) {
        const Shade one = by(i, place);
        if (one == Shade::lit) return one;
        if (one == Shade::cast) all = one;
    }
    return all;
}

Array<Shade> Shades::at(In<ShadedPlace> places) const {
    Array<Shade> shades(places.size());
    parallel_for(places.size(), 64, [&](std::size_t i) { shades[i] = at(places[i]); });
    return shades;
}

}  // namespace fovea::scene
