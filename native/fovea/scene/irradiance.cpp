// SPDX-License-Identifier: GPL-3.0-or-later
#include <fovea/scene/irradiance.h>

#include <cmath>

namespace fovea::scene {

bool shines(const Light& light) {
    const float total = light.color.x + light.color.y + light.color.z;
    const double turned = glm::length(light.direction);
    return std::isfinite(total) && brightness(light.color) > 0.0f && std::isfinite(glm::length(light.position)) &&
           std::isfinite(turned) && turned > 0.0;
}

vec3 arriving(const Light& light, const dvec3& point, vec3& to_light) {
    if (light.kind == Light::sun) {
        to_light = vec3(-light.direction);
        return light.color;
    }
    const dvec3 way = light.position - point;
    const double squared = glm::dot(way, way);
    if (!(squared > 0.0)) return vec3(0.0f);
    to_light = vec3(way / std::sqrt(squared));
    const float cosine = -glm::dot(to_light, vec3(light.direction));
    float share = 1.0f;
    if (light.kind == Light::spot) share = smooth_step(light.cos_outer, light.cos_inner, cosine);
    if (light.kind == Light::area) share = std::max(cosine, 0.0f);
    return light.color * static_cast<float>(share / squared);
}

float typical_irradiance(In<Light> lights, const Scene& scene, const View& view) {
    std::vector<float> found;
    for (const Placement& placement : scene.placements) {
        const Sphere sphere = bounding_sphere(placement, view);
        float squares = 0.0f;
        for (Light light : lights) {
            if (light.kind != Light::sun) light.kind = Light::point;
            vec3 to_light;
            const float arrives = brightness(arriving(light, sphere.center, to_light));
            squares += arrives * arrives;
        }
        if (std::isfinite(squares)) found.push_back(std::sqrt(squares));
    }
    if (found.empty()) return 0.0f;
    const auto middle = found.begin() + std::ptrdiff_t(found.size() / 2);
    std::nth_element(found.begin(), middle, found.end());
    return *middle > 0.0f ? *middle : *std::max_element(found.begin(), found.end());
}

}  // namespace fovea::scene
