// SPDX-License-Identifier: GPL-3.0-or-later
// Fairing: lines along the edges of a rounded surface's mesh without the zigzag of those edges. Cf. Taubin, "Curve and
// Surface Smoothing without Shrinkage", ICCV 1995; the parabolas are those of base/polyline_fit.h.
#pragma once

#include <fovea/path/paths.h>
#include <fovea/project/clipped_paths.h>
#include <fovea/scene/scene.h>

namespace fovea::runs {

/// Moves points of lines in the image to where parabolas along their lines have them: of creases on surfaces that are
/// not hard, by up to four tenths of an edge, and of contours along mesh edges of rounded ones, by up to `contour_px`
/// at most. Points stay at ends of pieces, where another line ends, and at edges that are marked sharp or have other
/// lines as well. Only the positions in the image change: what hides lines was found where they are, and arc lengths
/// stay those of the edges. Parallel; the result does not depend on the number of threads.
void fair(ClippedPaths& clipped, const Paths& paths, const Scene& scene, double contour_px);

}  // namespace fovea::runs
