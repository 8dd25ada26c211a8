// SPDX-License-Identifier: GPL-3.0-or-later
// Splits visible runs into outer silhouette and interior contour by casting rays behind them: drafts do so instead of
// classifying every edge of the mesh.
// Isenberg et al., "A Developer's Guide to Silhouette Algorithms for Polygonal Models", CG&A 2003.
#pragma once

#include <fovea/base/parallel.h>
#include <fovea/path/paths.h>
#include <fovea/scene/tracer.h>
#include <fovea/visibility/runs.h>

namespace fovea::runs {

struct OuterParts {
    Runs runs;                  ///< the given runs, split
    Array<std::uint8_t> outer;  ///< per run: 1 if its own placement does not continue behind it
    Array<Index> source;        ///< per run: first point, in Paths, of the segment on which it begins
};

/// Casts rays at the middles of equal parts, at most `step_px` pixels long; a single result between two that agree is
/// replaced by theirs. `sure` (one entry per path of Paths): segments of these kinds are not tested and count as outer.
/// Image-space lines lie on no placement: they must be sure. Throws std::invalid_argument for paths of another scene.
OuterParts outer_parts(const ClippedPaths& clipped, const Paths& paths, const Tracer& tracer, const Runs& runs,
                       In<Kinds> sure, double step_px, const Cancel& cancel);

}  // namespace fovea::runs
