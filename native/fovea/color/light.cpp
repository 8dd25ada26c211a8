// SPDX-License-Identifier: GPL-3.0-or-later
#include <fovea/color/light.h>

#include <algorithm>
#include <cmath>
#include <glm/gtc/constants.hpp>

#include <fovea/scene/irradiance.h>

namespace fovea::color {
namespace {

/// Bounds of the ambient share: shadow sides stay readable, and distinct from lit ones.
constexpr float least_ambient = 0.2f, most_ambient = 0.6f;
/// Half the width of the step between two bands, as a share of full light.
constexpr float soft_step = 0.012f;
/// Sine of the height of a light above a surface from which on it counts in full for flat colors.
constexpr float soft_turn = 0.04f;

/// Where polygons stand for a smooth surface, its normal: shadows end on its light contours, not along facets.
const vec3& meant(const vec3& normal, const Reach& reach) { return reach.smooth == vec3(0.0f) ? normal : reach.smooth; }

}  // namespace

Lighting::Lighting(In<Light> lights, const vec3& world, const Scene& scene, const View& view, const style::Color& style)
    : shading_(style.shading), bands_(std::max(style.bands, 2)), shadow_(float(style.shadow)) {
    const dmat3 turn(view.world_to_view);
    for (Light light : lights) {
        if (!shines(light)) continue;
        light.position = dvec3(view.world_to_view * dvec4(light.position, 1.0));
        light.direction = glm::normalize(turn * light.direction);
        lights_.push_back(light);
    }
    const float full = typical_irradiance(lights_, scene, view);
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

vec3 Lighting::irradiance(const dvec3& point, const vec3& normal, const vec3& to_eye, In<float> left) const {
    if (headlight_) return vec3(std::max(glm::dot(normal, to_eye), 0.0f));
    vec3 sum(0.0f);
    for (std::size_t i = 0; i < lights_.size(); ++i) {
        vec3 to_light(0.0f);
        vec3 arrives = arriving(lights_[i], point, to_light);
        if (i < left.size()) arrives *= left[i];
        sum += arrives * std::max(glm::dot(normal, to_light), 0.0f);
    }
    return sum;
}

/// Of the light that arrives there, wherever it comes from, the share that is left by shadows; sides turned away from a
/// light are in its shadow.
float Lighting::lit_share(const dvec3& point, const vec3& normal, const Reach& reach) const {
    if (headlight_) return 1.0f;
    float all = 0.0f, left = 0.0f;
    for (std::size_t i = 0; i < lights_.size(); ++i) {
        vec3 to_light(0.0f);
        const float arrives = brightness(arriving(lights_[i], point, to_light));
        const float away = 1.0f - smooth_step(0.0f, soft_turn, glm::dot(meant(normal, reach), to_light));
        all += arrives;
        left += arrives * std::min(i < most_casters ? reach.left[i] : 1.0f, 1.0f - shadow_ * away);
    }
    return all > 0.0f ? left / all : 1.0f - shadow_;
}

float Lighting::tone(const dvec3& point, const vec3& normal, const vec3& to_eye, const Reach& reach) const {
    return brightness(irradiance(point, meant(normal, reach), to_eye, reach.middle));
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

vec3 Lighting::at(const dvec3& point, const vec3& normal, const vec3& to_eye, const Reach* reach) const {
    if (shading_ == Shading::flat) return vec3(reach ? lit_share(point, normal, *reach) : 1.0f);
    const vec3 direct = irradiance(point, normal, to_eye, reach ? In<float>(reach->left) : In<float>());
    const float full = brightness(direct), share = std::min(full, 1.0f);
    vec3 tint(0.0f);
    if (full > 0.0f) tint = direct / full * (shading_ == Shading::toon ? banded(share) : share);
    return ambient_share_ * ambient_ + (1.0f - ambient_share_) * tint;
}

}  // namespace fovea::color
