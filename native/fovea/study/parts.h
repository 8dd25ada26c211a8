// SPDX-License-Identifier: GPL-3.0-or-later
// Connected parts of sets of pixels.
#pragma once

#include <fovea/study/bitmap.h>

namespace fovea::study {

/// Numbers of the pixels of each connected part (8 neighbors).
Lists<Index> parts_of(const Bitmap& bitmap);

/// Without parts of fewer than `least` pixels.
Bitmap without_specks(const Bitmap& bitmap, std::size_t least);

}  // namespace fovea::study
