// SPDX-License-Identifier: GPL-3.0-or-later
// Gaussian blur of a buffer.
#pragma once

#include <fovea/image/lattice.h>

namespace fovea::image {

/// Gaussian blur with `sigma` in steps of the buffer, cut off at 3.5 sigma; border values are repeated outwards.
Buffer gaussian(const Buffer& values, int width, int height, double sigma);

}  // namespace fovea::image
