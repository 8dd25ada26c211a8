// SPDX-License-Identifier: GPL-3.0-or-later
#include <fovea/line/tone.h>

#include <algorithm>

#include <fovea/scene/irradiance.h>
#include <fovea/scene/light_view.h>

namespace fovea::line {

Tone::Tone(const Tracer& tracer, int lights, bool shadows)
    : view_(tracer.view()), to_world_(glm::inverse(view_.world_to_view)) {
    const Scene& scene = tracer.scene();
    std::vector<Light> seen = casting_lights(scene, std::size_t(lights), false);
    const dmat3 turn(view_.world_to_view);
    for (Light& light : seen) {
        light.position = dvec3(view_.world_to_view * dvec4(light.position, 1.0));
        light.direction = glm::normalize(turn * light.direction);
    }
    const float full = typical_irradiance(seen, scene, view_);
    if (!(full > 0.0f)) return;
    for (Light& light : seen) light.color /= full;
    lights_ = std::move(seen);
    if (shadows) shades_ = std::make_unique<const Shades>(scene, lights_.size());
}

double Tone::at(const dvec3& point, const dvec3& normal, Lit lit) const {
    if (lights_.empty()) {
        const dvec3 to_eye = view_.orthographic ? dvec3(0, 0, 1) : -glm::normalize(point);
        return std::clamp(glm::dot(normal, to_eye), 0.0, 1.0);
    }
    double sum = 0.0;
    for (std::size_t i = 0; i < lights_.size(); ++i) {
        if (!(lit >> i & 1)) continue;
        vec3 to_light(0.0f);
        const float arrives = brightness(arriving(lights_[i], point, to_light));
        sum += arrives * std::max(glm::dot(normal, dvec3(to_light)), 0.0);
    }
    return std::min(sum, 1.0);
}

Tone::Lit Tone::lit_at(const ShadedSurface& surface, Index triangle, const dvec3& point) const {
    if (!shades_) return all;
    const ShadedPlace place = surface.at(triangle, dvec3(to_world_ * dvec4(point, 1.0)));
    Lit lit = 0;
    for (std::size_t i = 0; i < lights_.size(); ++i) lit |= Lit(shades_->by(i, place) == Shade::lit) << i;
    return lit;
}

}  // namespace fovea::line
