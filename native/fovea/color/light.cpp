// SPDX-License-Identifier: GPL-3.0-or-later
#include <fovea/color/light.h>

#include <algorithm>
#include <cmath>
#include <glm/gtc/constants.hpp>

#include <fovea/base/view.h>
#include <fovea/scene/scene.h>

namespace fovea::color {
namespace {

/// Bounds of the ambient share: shadow sides stay readable, and distinct from lit ones.
constexpr float least_ambient = 0.2f, most_ambient = 0.6f;
/// Half the width of the step between two bands, as a share of full light.
constexpr float soft_step = 0.012f;

/// Strongest channel, so that a white surface in colored light keeps its hue up to full light.
float brightness(const vec3& color) { return std::max({color.x, color.y, color.z}); }

float smooth_step(float low, float high, float x) {
    const float t = std::clamp((x - low) / std::max(high - low, 1e-6f), 0.0f, 1.0f);
    return t * t * (3.0f - 2.0f * t);
}

/// Irradiance by a light at a point on a surface that faces it; sets the unit vector to the light.
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

bool usable(const Light& light) {
    const float total = light.color.x + light.color.y + light.color.z;
    const double turned = glm::length(light.direction);
    return std::isfinite(total) && brightness(light.color) > 0.0f && std::isfinite(glm::length(light.position)) &&
           std::isfinite(turned) && turned > 0.0;
}

/// Median over the placements of the irradiance at their centers from all lights, with spots and areas counted as point
/// lights, as most of them light only a part of a floor.
float typical(const std::vector<Light>& lights, const Scene& scene, const View& view) {
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

}  // namespace

Lighting::Lighting(In<Light> lights, const vec3& world, const Scene& scene, const View& view, const style::Color& style)
    : shading_(style.shading), bands_(std::max(style.bands, 2)) {
    const dmat3 turn(view.world_to_view);
    for (Light light : lights) {
        if (!usable(light)) continue;
        light.position = dvec3(view.world_to_view * dvec4(light.position, 1.0));
        light.direction = glm::normalize(turn * light.direction);
        lights_.push_back(light);
    }
    const float full = typical(lights_, scene, view);
    headlight_ = !(full > 0.0f);
    if (headlight_) {
        lights_.clear();
        return;
    }
    for (Light& light : lights_) light.color /= full;
    const float sky = std::isfinite(world.x + world.y + world.z) ? brightness(world) : 0.0f,
                from_sky = glm::pi<float>() * std::max(sky, 0.0f);
    const float share = from_sky / (from_sky + full);
    ambient_share_ = share >= least_ambient ? std::min(share, most_ambient) : least_ambient;
    if (sky > 0.0f) ambient_ = glm::mix(vec3(1.0f), world / sky, 0.5f);
}

vec3 Lighting::irradiance(const dvec3& point, const vec3& normal, const vec3& to_eye) const {
    if (headlight_) return vec3(std::max(glm::dot(normal, to_eye), 0.0f));
    vec3 sum(0.0f);
    for (const Light& light : lights_) {
        vec3 to_light(0.0f);
        const vec3 arrives = arriving(light, point, to_light);
        sum += arrives * std::max(glm::dot(normal, to_light), 0.0f);
    }
    return sum;
}

float Lighting::banded(float share) const {
    const auto n = static_cast<float>(bands_);
    float steps = 0.0f;
    for (int i = 1; i < bands_; ++i) steps += smooth_step(float(i) / n - soft_step, float(i) / n + soft_step, share);
    return steps / (n - 1.0f);
}

int Lighting::band(const dvec3& point, const vec3& normal, const vec3& to_eye) const {
    if (shading_ != Shading::toon) return 0;
    const float share = std::min(brightness(irradiance(point, normal, to_eye)), 1.0f);
    return int(std::lround(banded(share) * float(bands_ - 1)));
}

vec3 Lighting::at(const dvec3& point, const vec3& normal, const vec3& to_eye) const {
    if (shading_ == Shading::flat) return vec3(1.0f);
    const vec3 direct = irradiance(point, normal, to_eye);
    const float full = brightness(direct), share = std::min(full, 1.0f);
    vec3 tint(0.0f);
    if (full > 0.0f) tint = direct / full * (shading_ == Shading::toon ? banded(share) : share);
    return ambient_share_ * ambient_ + (1.0f - ambient_share_) * tint;
}

}  // namespace fovea::color
