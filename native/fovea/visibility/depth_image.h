// SPDX-License-Identifier: GPL-3.0-or-later
// The depth pass: distance along the view axis of the first surface at each pixel center.
#pragma once

#include <fovea/base/parallel.h>
#include <fovea/scene/tracer.h>

namespace fovea::visibility {

/// Depth of background pixels, as written by Blender's own engines.
inline constexpr float background_depth = 1e10f;

/// Distance along -z [view space] of the nearest occluding surface at each pixel center of the tracer's view; width *
/// height, bottom row first. Rasterized, not ray traced: at most a tenth of the time. Throws std::invalid_argument
/// where a surface has moved since the tracer was made.
Array<float> depth_image(const Tracer& tracer, const Cancel& cancel);

}  // namespace fovea::visibility
