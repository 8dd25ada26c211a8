// SPDX-License-Identifier: GPL-3.0-or-later
// Gaps that a mesh makes in contours and suggestive contours of the smooth surface it stands for.
#pragma once

#include <fovea/path/paths.h>
#include <fovea/scene/tracer.h>
#include <fovea/visibility/runs.h>

namespace fovea::runs {

/// The contour of a smooth surface runs inside of its mesh in places, whose facets hide it there; where a surface turns
/// away, facets hide lines near its contour, too. Closes gaps of at most `gap_px` between visible runs of
/// view-dependent paths (Paths::of_view) that do not run along mesh edges, where rays every two pixels meet their own
/// placement first, and that no farther before the line than four times the gap's length in space: nearer than that a
/// part in front of it can hardly be. `visible`: runs of invisibility 0.
Runs without_own_roughness(const ClippedPaths& clipped, const Paths& paths, const Tracer& tracer, const Runs& visible,
                           double gap_px);

}  // namespace fovea::runs
