// SPDX-License-Identifier: GPL-3.0-or-later
// Contours of bumps that are too small to be seen as such.
#pragma once

#include <fovea/path/paths.h>
#include <fovea/scene/scene.h>
#include <fovea/visibility/runs.h>

namespace fovea::runs {

/// Removes closed paths with `of_view` set that are seen as a whole and smaller than `dot_px`, on connected parts of a
/// surface of which larger lines are seen. Parts that are themselves so small keep them. `visible`: runs of
/// invisibility 0.
Runs without_dots(const ClippedPaths& clipped, const Runs& visible, const Paths& paths, const Scene& scene,
                  double dot_px);

}  // namespace fovea::runs
