// SPDX-License-Identifier: GPL-3.0-or-later
// Lights.
#pragma once

#include <fovea/base/types.h>

namespace fovea::scene {

struct Light {
    enum Kind : std::uint8_t { sun, point, spot, area };
    Kind kind = sun;
    dvec3 position{0.0};        ///< world; of an area its center
    dvec3 direction{0, 0, -1};  ///< world: direction of emission; unused for points
    vec3 color{1.0f};           ///< of a sun the irradiance, W/m2; of others the intensity along their axis, W/sr
    float cos_outer = -1.0f;    ///< cosine of the angle to a spot's axis at which its light ends
    float cos_inner = -1.0f;    ///< and at which it begins to fall off
    dvec3 half_side[2] = {dvec3(0.0), dvec3(0.0)};  ///< world: of an area, from its center to the middles of two sides
    bool casts = true;                              ///< what it shines on casts a shadow
    /// Of a point or spot its radius, of a sun the tangent of half the angle that it is seen under: for soft shadows.
    double radius = 0.0;
    std::uint64_t id = 0;  ///< persistent, from which line ids are hashed
};

}  // namespace fovea::scene
