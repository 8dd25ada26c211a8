// SPDX-License-Identifier: GPL-3.0-or-later
// What is drawn in a picture: scans of paper, and pictures that are drawn by programs.
#pragma once

#include <fovea/color/png.h>
#include <fovea/study/bitmap.h>

namespace fovea::study {

/// The value of paper: the median of all. Below `dark_paper` what is drawn is brighter than that.
int paper_of(const color::GrayImage& picture);
inline constexpr int dark_paper = 128;

/// How much darker than the mean around it ink is, of 255.
inline constexpr int least_ink = 10;

/// The pixels that are darker than the paper around them: than the mean of a window of 31 pixels by `least_ink`, or
/// than a third of the paper; on dark paper those that are brighter. Specks of fewer than 6 pixels are left out. Both
/// sizes are those of a picture with a diagonal of 1280 pixels, and grow with larger ones.
Bitmap ink_of(const color::GrayImage& picture);

}  // namespace fovea::study
