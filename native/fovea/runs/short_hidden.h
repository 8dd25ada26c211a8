// SPDX-License-Identifier: GPL-3.0-or-later
// Hidden parts that are too short to be drawn.
#pragma once

#include <fovea/visibility/runs.h>

namespace fovea {

/// Runs without the hidden stretches that are shorter than their path's `least_px` (one entry per path of Paths):
/// crumbs beside small holes, and the ways back of contours that fold. A stretch is what lies hidden between two
/// visible runs, however many surfaces hide its parts; one that is a whole piece stays.
Runs without_short_hidden(const ClippedPaths& clipped, const Runs& runs, In<float> least_px);

}  // namespace fovea
