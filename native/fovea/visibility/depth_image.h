// SPDX-License-Identifier: GPL-3.0-or-later
// The depth pass: how far away along the view each pixel's center sees the first surface.
#pragma once

#include <fovea/base/parallel.h>
#include <fovea/scene/tracer.h>

namespace fovea::visibility {

/// Depth of pixels that see nothing, as Blender's own engines write it.
inline constexpr float background_depth = 1e10f;

/// Distance along -z [view space] of the nearest occluding surface at each pixel center of the tracer's view; width *
/// height, bottom row first. Drawn, not traced, which takes a tenth of the time or less. Throws
/// std::invalid_argument where a surface has moved since the tracer was made.
Array<float> depth_image(const Tracer& tracer, const Cancel& cancel);

}  // namespace fovea::visibility
