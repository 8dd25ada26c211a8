// SPDX-License-Identifier: GPL-3.0-or-later
// Light on surfaces, without shadows.
#pragma once

#include <fovea/base/view.h>
#include <fovea/scene/scene.h>
#include <fovea/style/ground.h>

namespace fovea::color {

using style::Shading;

/// The lights of a scene in view space, with automatic exposure: light that irradiates the middle of a typical
/// placement (the median) head on makes it as bright as its base color, whatever the units. The exposure depends on the
/// scene, not on the view, so that a moving camera does not change it. Without any effective light there is one at the
/// eye.
class Lighting {
   public:
    /// `world`: radiance of the sky, whose share of all light is ambient. `style`: shading, and bands for toon shading.
    Lighting(In<Light> lights, const vec3& world, const Scene& scene, const View& view, const style::Color& style);

    /// Brightness of a white surface: 1 in full light. View space; `normal` and `to_eye` of unit length, `normal`
    /// facing the viewer.
    vec3 at(const dvec3& point, const vec3& normal, const vec3& to_eye) const;
    /// Number of the band of toon shading there, from the darkest, in the middle of whose step the next begins; of
    /// other shading 0.
    int band(const dvec3& point, const vec3& normal, const vec3& to_eye) const;

    Shading shading() const { return shading_; }

   private:
    vec3 irradiance(const dvec3& point, const vec3& normal, const vec3& to_eye) const;
    float banded(float share) const;

    std::vector<Light> lights_;  // in view space, exposed
    bool headlight_ = false;
    Shading shading_;
    int bands_;
    float ambient_share_ = 0.35f;
    vec3 ambient_{1.0f};
};

}  // namespace fovea::color

namespace fovea::style {
template <>
inline constexpr Choice choices_of<scene::Light::Kind>[] = {{"sun"}, {"point"}, {"spot"}, {"area"}};
}  // namespace fovea::style
