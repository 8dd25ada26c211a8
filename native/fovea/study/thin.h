// SPDX-License-Identifier: GPL-3.0-or-later
// Strokes of scans as lines of single pixels.
#pragma once

#include <fovea/study/bitmap.h>

namespace fovea::study {

/// The skeleton of a set of pixels, one pixel wide and connected as the set is (8 neighbors). Guo & Hall, "Parallel
/// Thinning with Two-Subiteration Algorithms", CACM 1989.
Bitmap thinned(Bitmap bitmap);

}  // namespace fovea::study
