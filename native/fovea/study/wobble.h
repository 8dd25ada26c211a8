// SPDX-License-Identifier: GPL-3.0-or-later
// How a hand wobbles, told from how far strokes are from their lines.
#pragma once

#include <fovea/base/types.h>

namespace fovea::study {

using namespace vector;  // as in bitmap.h

/// As stroke::wobble has it.
struct Wobble {
    double amount = 0.0;      ///< [px] most; 0: none
    double length = 0.0;      ///< [px] of its waves
    std::size_t samples = 0;  ///< that it was told from
};

/// Of StrokeCourses. By mean squared differences of samples at several distances: these do not depend on how far a
/// whole line is off, and have a known shape for waves of each length, also near to ends of lines, where there is no
/// wobble. What they have at all distances alike is the pixels' own. None where lines that are turned explain as much.
/// `longest` [px]: of waves.
Wobble fitted_wobble(In<float> away, In<std::int64_t> first, double longest);

}  // namespace fovea::study
