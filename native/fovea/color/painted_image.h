// SPDX-License-Identifier: GPL-3.0-or-later
// Image of a painted mesh attribute.
#pragma once

#include <fovea/base/parallel.h>
#include <fovea/path/painted.h>
#include <fovea/scene/tracer.h>

namespace fovea::color {

/// The painted value at each pixel (width * height, bottom row first), sampled like the color layer: the mean over the
/// pixel, where background counts as 0. Throws as check_painted and color_layer.
Array<float> painted_image(const Tracer& tracer, const Painted& painted, const Cancel& cancel);

}  // namespace fovea::color
