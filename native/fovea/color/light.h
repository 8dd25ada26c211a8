// SPDX-License-Identifier: GPL-3.0-or-later
// Light on surfaces, without shadows.
#pragma once

#include <fovea/base/view.h>
#include <fovea/scene/scene.h>
#include <fovea/style/ground.h>

namespace fovea::color {

using style::Shading;

struct Light {
    enum Kind : std::uint8_t { sun, point, spot, area };
    Kind kind = sun;
    dvec3 position{0.0};        ///< world
    dvec3 direction{0, 0, -1};  ///< world: where it shines; points shine everywhere
    vec3 color{1.0f};           ///< of a sun the irradiance, W/m2; of others the intensity along their axis, W/sr
    float cos_outer = -1.0f;    ///< of the angle to a spot's axis where its light ends
    float cos_inner = -1.0f;    ///< and where it begins to fade
};

/// The lights of a scene as a view needs them, exposed for the picture: what irradiates the middle of most placements
/// head on makes them as bright as their base color, whatever the units. The exposure looks at the scene, not at the
/// view, so that a moving camera does not change it. Where no light reaches anything there is one at the eye.
class Lighting {
   public:
    /// `world`: radiance of the sky, whose share of the light is ambient. `style`: shading, and bands if it is in some.
    Lighting(In<Light> lights, const vec3& world, const Scene& scene, const View& view, const style::Color& style);

    /// How bright a white surface is: 1 in full light. View space; `normal` and `to_eye` of unit length, `normal`
    /// turned to the viewer.
    vec3 at(const dvec3& point, const vec3& normal, const vec3& to_eye) const;

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
inline constexpr Choice choices_of<color::Light::Kind>[] = {{"sun"}, {"point"}, {"spot"}, {"area"}};
}  // namespace fovea::style
