// SPDX-License-Identifier: GPL-3.0-or-later
// Exact Euclidean distances from a set of pixels, in time proportional to their number. Meijster, Roerdink & Hesselink,
// "A General Algorithm for Computing Distance Transforms in Linear Time", 2000; Felzenszwalb & Huttenlocher, 2012.
#pragma once

#include <fovea/study/bitmap.h>

namespace fovea::study {

/// For each pixel the number of the nearest one that is set; `none` if none is.
Array<Index> nearest_pixels(const Bitmap& bitmap);

/// For each pixel the distance [px] between its center and that of the nearest one that is set; infinite if none is.
Array<float> distances_to(const Bitmap& bitmap);

}  // namespace fovea::study
