// SPDX-License-Identifier: GPL-3.0-or-later
// Bevels that are narrow on paper have one line, not two.
#pragma once

#include <fovea/scene/scene.h>
#include <fovea/visibility/runs.h>

namespace fovea::runs {

/// Removes the parts of creases whose strip (field/strips.h), down to another line at its other edge, is narrower than
/// the path's `least_px` in the image. Of two creases that of the later path goes; one beside another kind of line
/// always does.
Runs without_narrow_strips(const ClippedPaths& clipped, const Runs& runs, const Paths& paths, const Scene& scene,
                           const View& view, In<float> least_px);

}  // namespace fovea::runs
