// SPDX-License-Identifier: GPL-3.0-or-later
// Small spots of blacks, as bumps have where the light is low, and small holes in blacks: no brush would make them.
#pragma once

#include <fovea/base/types.h>

namespace fovea::color {

/// What is decided of a pixel, whatever its tone.
enum class Spot : std::uint8_t { as_is, open, filled };

/// Spots of black of fewer than `least` pixels are open, and so is what is beside no other black; holes of fewer are
/// filled, and what is beside them and no other hole. What reaches the border of the picture is none. `black`: 1 or 0
/// per pixel.
Array<Spot> small_spots(const Array<std::uint8_t>& black, int width, double least);

}  // namespace fovea::color
