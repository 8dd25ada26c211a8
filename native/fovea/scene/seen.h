// SPDX-License-Identifier: GPL-3.0-or-later
// What the camera sees at each pixel of the holes that holdouts cut.
#pragma once

#include <fovea/base/parallel.h>
#include <fovea/scene/tracer.h>

namespace fovea::scene {

/// Share of each pixel (of 4 samples) in which a holdout is the first thing seen; width * height, bottom row first.
/// Empty when the scene has no holdout.
Array<float> holdout_image(const Tracer& tracer, const Cancel& cancel);

}  // namespace fovea::scene
