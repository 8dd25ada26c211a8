// SPDX-License-Identifier: GPL-3.0-or-later
// Quantized edge equations of the triangle that covers a texel: on which side of an occluder's edge a probe lies.
#pragma once

#include <fovea/base/types.h>

namespace fovea::visibility::formulas {

using namespace glm;

/// Their error is at most 1/64 + 1/510 texel.
struct Edges {
#include <shared/edges.glsl>
};

}  // namespace fovea::visibility::formulas
