// SPDX-License-Identifier: GPL-3.0-or-later
#include <fovea/style/animation.h>

namespace fovea::style {
namespace {

/// The whole number below the quotient; `divisor` is positive.
int floor_divided(int number, int divisor) { return number / divisor - (number % divisor < 0); }

}  // namespace

int Animation::held(int frame) const { return start_frame + floor_divided(frame - start_frame, hold) * hold; }

int Animation::since_key(int frame) const {
    if (marks_frames <= 0) return 0;
    return frame - start_frame - floor_divided(frame - start_frame, marks_frames) * marks_frames;
}

int Animation::boil_drawing(int frame) const {
    if (boil <= 0.0) return 0;
    const int drawing = floor_divided(frame - start_frame, boil_hold);
    return drawing - floor_divided(drawing, boil_cycle) * boil_cycle;
}

}  // namespace fovea::style
