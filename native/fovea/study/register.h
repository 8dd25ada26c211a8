// SPDX-License-Identifier: GPL-3.0-or-later
// Registration: how a scanned drawing lies over the picture that it was drawn after.
#pragma once

#include <fovea/study/homography.h>

namespace fovea::study {

struct Registration {
    Homography to_scan{1.0};  ///< from pixels of the reference to those of the scan
    /// Share of the reference's outer boundary within the tolerance of the registered scan. Cole 2009 keeps drawings
    /// from 0.9 on.
    double outer_share = 0.0;
};

/// By their lines: a similarity (rotation up to 16 degrees, three quarters to four thirds of the size that fits) is
/// searched that brings both near to each other, and refined to a homography by iterated closest points. `tolerance`:
/// of the outer share, in pixels of the reference. None if one of the drawings is empty.
std::optional<Registration> registered(const Bitmap& scan, const Bitmap& reference, double tolerance);

/// The pixels of a drawing that can be reached from the border of the picture through gaps wider than 2 * `gap` pixels.
Bitmap outer_pixels(const Bitmap& drawing, double gap);

}  // namespace fovea::study
