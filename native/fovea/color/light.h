// SPDX-License-Identifier: GPL-3.0-or-later
// Light on surfaces.
#pragma once

#include <array>

#include <fovea/base/view.h>
#include <fovea/scene/scene.h>
#include <fovea/style/ground.h>

namespace fovea::color {

using style::Shading;

/// How many lights cast shadows on colors: the strongest, as of light_view.h.
inline constexpr std::size_t most_casters = 8;

/// What shadows leave of the first lights.
struct Reach {
    std::array<float, most_casters> left;    ///< of each its share, for colors
    std::array<float, most_casters> middle;  ///< 1: its middle is seen, else 0; for tones
    vec3 smooth{0.0f};  ///< unit normal, in view space, of the smooth surface that polygons stand for; 0: they do not

    Reach() {
        left.fill(1.0f);
        middle.fill(1.0f);
    }
};

/// The lights of a scene in view space, with automatic exposure: light that irradiates the middle of a typical
/// placement (the median) head on makes it as bright as its base color, whatever the units. The exposure depends on the
/// scene, not on the view, so that a moving camera does not change it. Without any effective light there is one at the
/// eye.
class Lighting {
   public:
    /// `world`: radiance of the sky, whose share of all light is ambient. `style`: shading, and bands for toon shading.
    Lighting(In<Light> lights, const vec3& world, const Scene& scene, const View& view, const style::Color& style);

    /// Brightness of a white surface: 1 in full light. View space; `normal` and `to_eye` of unit length, `normal`
    /// facing the viewer. `reach`: null without shadows; of the first lights that were given.
    vec3 at(const dvec3& point, const vec3& normal, const vec3& to_eye, const Reach* reach = nullptr) const;
    /// Light that arrives there, whatever the shading: 1 is full light. Without that of the sky.
    float tone(const dvec3& point, const vec3& normal, const vec3& to_eye, const Reach& reach) const;
    /// Number of the band of toon shading there, from the darkest, in the middle of whose step the next begins; of
    /// other shading 0.
    int band(const dvec3& point, const vec3& normal, const vec3& to_eye) const;

    Shading shading() const { return shading_; }

   private:
    vec3 irradiance(const dvec3& point, const vec3& normal, const vec3& to_eye, In<float> left = {}) const;
    float lit_share(const dvec3& point, const vec3& normal, const Reach& reach) const;
    float banded(float share) const;

    std::vector<Light> lights_;  // in view space, exposed
    bool headlight_ = false;
    Shading shading_;
    int bands_;
    float shadow_;
    float ambient_share_ = 0.35f;
    vec3 ambient_{1.0f};
};

}  // namespace fovea::color

namespace fovea::style {
template <>
inline constexpr Choice choices_of<scene::Light::Kind>[] = {{"sun"}, {"point"}, {"spot"}, {"area"}};
}  // namespace fovea::style
