// SPDX-License-Identifier: GPL-3.0-or-later
// A camera before a model, as `fovea draw` places it.
#pragma once

#include <fovea/base/view.h>

namespace fovea::tool {

using namespace draw;

struct Camera {
    double azimuth = 35.0;    ///< degrees left of the model's front
    double elevation = 25.0;  ///< degrees above it
    double lens = 50.0;       ///< millimetres, before a sensor whose longer side has 36
    double margin = 5.0;      ///< percent of the picture that stays free on each side
    int width = 1920;         ///< pixels
    int height = 1080;
};

/// As near as shows all positions; those that are not finite do not count. `y_up`: the model's y is up and its front
/// looks along z, else z is up and its front looks along -y. Throws std::invalid_argument for what leaves no picture.
View view_of(In<vec3> positions, const Camera& camera, bool y_up);

}  // namespace fovea::tool
