// SPDX-License-Identifier: GPL-3.0-or-later
// Alpha mask of holdouts.
#pragma once

#include <fovea/base/parallel.h>
#include <fovea/scene/tracer.h>

namespace fovea::scene {

/// Share of each pixel (of 4 samples) where the nearest surface is a holdout; width * height values, bottom row first.
/// Empty if the scene has no holdout.
Array<float> holdout_image(const Tracer& tracer, const Cancel& cancel);

}  // namespace fovea::scene
