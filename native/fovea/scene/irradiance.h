// SPDX-License-Identifier: GPL-3.0-or-later
// Irradiance of surfaces by lights, without shadows. Points and lights are in one space, whichever that is.
#pragma once

#include <algorithm>

#include <fovea/base/view.h>
#include <fovea/scene/scene.h>

namespace fovea::scene {

/// Strongest channel, so that a white surface in colored light keeps its hue up to full light.
inline float brightness(const vec3& color) { return std::max({color.x, color.y, color.z}); }

/// 0 below `low`, 1 above `high`, and a smooth step between.
inline float smooth_step(float low, float high, float x) {
    const float t = std::clamp((x - low) / std::max(high - low, 1e-6f), 0.0f, 1.0f);
    return t * t * (3.0f - 2.0f * t);
}

/// Whether a light shines, from somewhere.
bool shines(const Light& light);

/// Irradiance by a light (with a direction of unit length) at a point on a surface that faces it; sets the unit vector
/// to the light.
vec3 arriving(const Light& light, const dvec3& point, vec3& to_light);

/// Median over the placements of the irradiance at their centers from all lights, with spots and areas counted as point
/// lights, as most of them light only a part of a floor. `view`: to whose space the lights belong.
float typical_irradiance(In<Light> lights, const Scene& scene, const View& view);

}  // namespace fovea::scene
