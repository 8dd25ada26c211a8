// SPDX-License-Identifier: GPL-3.0-or-later
// A scene as its lights see it: views of all around, without a frame. The eye of a Tracer is then the light.
#pragma once

#include <fovea/scene/scene.h>

namespace fovea::scene {

/// The view from a light: of a sun orthographic, with all that hides before the eye. There is no near plane (it is at
/// 0), and view_to_clip is 0. The light is moved by 2^-22 of its distance, so that surfaces that are parallel to axes,
/// as walls and a sun overhead, are not seen exactly edge-on.
View view_from(const Light& light, const Scene& scene);

/// Radius of a sphere around all that hides; 0 if there is nothing.
double radius_of(const Scene& scene);

/// Step at which lights look along edges, so that nothing of the size of a thing is missed: a sixteenth of the median
/// radius of the placements that hide, but no more than 2^-9 of that of the scene.
double step_of(const Scene& scene);

/// The lights that cast shadows, at most `most`, the strongest at the middle of the scene first. Areas are points at
/// their centers; with `corners` their corners follow, as four points.
std::vector<Light> casting_lights(const Scene& scene, std::size_t most, bool corners);

/// Whether it shines from somewhere, and casts shadows.
bool can_cast(const Light& light);
/// The same of given lights, without corners.
std::vector<Light> casting_lights(In<Light> lights, const Scene& scene, std::size_t most);

/// Cosine of the angle to a light's direction beyond which it does not shine.
inline double cone_of(const Light& light) {
    return light.kind == Light::spot ? light.cos_outer : light.kind == Light::area ? 0.0 : -1.0;
}

}  // namespace fovea::scene
