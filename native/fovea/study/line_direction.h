// SPDX-License-Identifier: GPL-3.0-or-later
// Which way lines of single pixels run.
#pragma once

#include <fovea/study/bitmap.h>

namespace fovea::study {

/// The unit vector across the line through pixel (x, y), which is set, by the pixels up to `within` away; (0, 0) where
/// these run neither way more than the other.
vec2 normal_at(const Bitmap& lines, int x, int y, int within);

}  // namespace fovea::study
