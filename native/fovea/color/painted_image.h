// SPDX-License-Identifier: GPL-3.0-or-later
// What the artist has painted, as the picture shows it.
#pragma once

#include <fovea/base/parallel.h>
#include <fovea/path/painted.h>
#include <fovea/scene/tracer.h>

namespace fovea::color {

/// The painted value of what each pixel sees (width * height, bottom row first), as the color layer sees it: the mean
/// over the pixel, where what no surface covers counts 0. Throws as check_painted and color_layer.
Array<float> painted_image(const Tracer& tracer, const Painted& painted, const Cancel& cancel);

}  // namespace fovea::color
