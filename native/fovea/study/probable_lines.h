// SPDX-License-Identifier: GPL-3.0-or-later
// Lines along the crests of a picture of probabilities. Cole 2009, figure 3.14.
#pragma once

#include <fovea/study/plane.h>
#include <fovea/study/precision_recall.h>

namespace fovea::study {

/// The picture, blurred by 1.5 pixels of one with a diagonal of 1280, at the pixels on its crests: its maxima along the
/// direction in which it bends most, within the pixel; where it hardly bends there are none. Steger, "An Unbiased
/// Detector of Curvilinear Structures", PAMI 1998.
Strengths crests_of(const Plane& probability);

/// Crests that are as strong as the threshold somewhere, as far as they have half of it, one pixel wide, by Canny's
/// hysteresis; without those of fewer than 8 pixels in a picture of that diagonal.
Bitmap lines_of(const Strengths& crests, double threshold);

}  // namespace fovea::study
