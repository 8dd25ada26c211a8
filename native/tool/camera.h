// SPDX-License-Identifier: GPL-3.0-or-later
// Placement of a camera in front of a model, as in `fovea draw`.
#pragma once

#include <fovea/base/view.h>

namespace fovea::tool {

using namespace draw;

struct Camera {
    double azimuth = 35.0;    ///< degrees left of the model's front
    double elevation = 25.0;  ///< degrees above it
    double lens = 50.0;       ///< focal length [mm], for a sensor whose longer side is 36 mm
    double margin = 5.0;      ///< free border on each side [% of the picture]
    int width = 1920;         ///< pixels
    int height = 1080;
};

/// Moves the camera as near as still shows all positions; non-finite ones are ignored. `y_up`: the model's y is up and
/// its front faces z, else z is up and its front faces -y. Throws std::invalid_argument for values that give no
/// picture.
View view_of(In<vec3> positions, const Camera& camera, bool y_up);

}  // namespace fovea::tool
