// What the camera sees at each pixel of the holes that holdouts cut.
#pragma once

#include "base/parallel.h"
#include "scene/tracer.h"

namespace fovea {

/// Share of each pixel (of 4 samples) in which a holdout is the first thing seen; width * height, bottom row first.
/// Empty when the scene has no holdout.
Array<float> holdout_image(const Tracer& tracer, const Cancel& cancel);

}  // namespace fovea
