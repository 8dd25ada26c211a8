// SPDX-License-Identifier: GPL-3.0-or-later
// Gaussian smoothing of a buffer.
#pragma once

#include <fovea/image/lattice.h>

namespace fovea::image {

/// Values under a Gaussian of so many steps, cut off at 3.5 sigma; beyond the border the last values repeat.
Buffer gaussian(const Buffer& values, int width, int height, double sigma);

}  // namespace fovea::image
