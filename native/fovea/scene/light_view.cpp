// SPDX-License-Identifier: GPL-3.0-or-later
#include <fovea/scene/light_view.h>

#include <algorithm>
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>
#include <limits>

#include <fovea/base/hash.h>

namespace fovea::scene {
namespace {

/// Along no plane that meshes are likely to have.
const dvec3 nudge = 0x1p-22 * glm::normalize(dvec3(0.43, 0.71, 0.56));

/// Spheres around the placements that hide, in the world.
std::vector<Sphere> spheres_of(const Scene& scene) {
    std::vector<Sphere> spheres;
    for (const Placement& placement : scene.placements) {
        if (!(placement.usage & (usage_occlude | usage_holdout))) continue;
        const Sphere own = bounding_sphere(placement, View());
        const double sum = own.center.x + own.center.y + own.center.z + own.radius;
        if (std::isfinite(sum) && own.radius > 0.0) spheres.push_back(own);
    }
    return spheres;
}

Sphere around(const std::vector<Sphere>& spheres) {
    dvec3 low(std::numeric_limits<double>::infinity()), high = -low;
    for (const Sphere& sphere : spheres) {
        low = glm::min(low, sphere.center - sphere.radius);
        high = glm::max(high, sphere.center + sphere.radius);
    }
    if (!(low.x <= high.x)) return {dvec3(0.0), 0.0};
    return {0.5 * (low + high), 0.5 * glm::distance(low, high)};
}

double irradiance(const Light& light, const dvec3& at) {
    const double shines = light.color.x + light.color.y + light.color.z;
    const dvec3 way = at - light.position;
    return light.kind == Light::sun ? shines : shines / std::max(glm::dot(way, way), 1e-30);
}

}  // namespace

View view_from(const Light& light, const Scene& scene) {
    const Sphere all = around(spheres_of(scene));
    View view;
    view.view_to_clip = dmat4(0.0);
    view.near_clip = 0.0;
    view.orthographic = light.kind == Light::sun;
    if (!view.orthographic) {
        view.world_to_view = glm::translate(dmat4(1.0), -(light.position + nudge * all.radius));
        return view;
    }
    const dvec3 towards = glm::normalize(nudge - glm::normalize(light.direction));
    const dvec3 size = glm::abs(towards);
    const dvec3 least = size.x <= size.y && size.x <= size.z ? dvec3(1, 0, 0)
                        : size.y <= size.z                   ? dvec3(0, 1, 0)
                                                             : dvec3(0, 0, 1);
    const dvec3 right = glm::normalize(glm::cross(least, towards)), up = glm::cross(towards, right);
    const dmat4 turn(glm::transpose(dmat3(right, up, towards)));
    view.world_to_view =
        glm::translate(dmat4(1.0), dvec3(0, 0, -1.1 * all.radius)) * turn * glm::translate(dmat4(1.0), -all.center);
    return view;
}

double radius_of(const Scene& scene) { return around(spheres_of(scene)).radius; }

double step_of(const Scene& scene) {
    std::vector<Sphere> spheres = spheres_of(scene);
    if (spheres.empty()) return 0.0;
    const auto middle = spheres.begin() + std::ptrdiff_t(spheres.size() / 2);
    std::ranges::nth_element(spheres, middle, {}, &Sphere::radius);
    return std::min(middle->radius / 16.0, 0x1p-9 * around(spheres).radius);
}

bool can_cast(const Light& light) {
    const dvec3 sum = light.position + light.direction + light.half_side[0] + light.half_side[1];
    const float shines = light.color.x + light.color.y + light.color.z;
    return light.casts && std::isfinite(sum.x + sum.y + sum.z) && glm::length(light.direction) > 0.0 && shines > 0.0f &&
           std::isfinite(shines);
}

std::vector<Light> casting_lights(In<Light> of, const Scene& scene, std::size_t most) {
    std::vector<Light> lights;
    std::ranges::copy_if(of, std::back_inserter(lights), can_cast);
    const dvec3 middle = around(spheres_of(scene)).center;
    std::ranges::stable_sort(
        lights, [&](const Light& a, const Light& b) { return irradiance(a, middle) > irradiance(b, middle); });
    if (lights.size() > most) lights.resize(most);
    for (Light& light : lights) light.direction = glm::normalize(light.direction);
    return lights;
}

std::vector<Light> casting_lights(const Scene& scene, std::size_t most, bool corners) {
    std::vector<Light> lights = casting_lights(scene.lights, scene, most);
    if (!corners) return lights;
    std::vector<Light> with;
    for (const Light& light : lights) {
        with.push_back(light);
        for (int k = 0; k < 4 && light.kind == Light::area; ++k) {
            Light& corner = with.emplace_back(light);
            corner.position += (k & 1 ? 1.0 : -1.0) * light.half_side[0] + (k & 2 ? 1.0 : -1.0) * light.half_side[1];
            corner.id = hash_numbers(light.id, k);
        }
    }
    return with;
}

}  // namespace fovea::scene
