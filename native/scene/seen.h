// What the camera sees at each pixel: the depth pass and the holes that holdouts cut.
#pragma once

#include "base/parallel.h"
#include "scene/tracer.h"

namespace fovea {

/// Depth of pixels that see nothing, as Blender's own engines write it.
inline constexpr float background_depth = 1e10f;

/// Distance along the view direction of the surface at each pixel centre; width * height, bottom row first.
Array<float> depth_image(const Tracer& tracer, const Cancel& cancel);

/// Share of each pixel (of 4 samples) in which a holdout is the first thing seen; width * height, bottom row first.
/// Empty when the scene has no holdout.
Array<float> holdout_image(const Tracer& tracer, const Cancel& cancel);

}  // namespace fovea
