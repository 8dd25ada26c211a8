// SPDX-License-Identifier: GPL-3.0-or-later
// Splits runs into outer silhouette and interior contour by casting rays behind them: drafts do so instead of
// classifying every edge of the mesh, and outlines of groups leave out what lies between their members. Isenberg et
// al., "A Developer's Guide to Silhouette Algorithms for Polygonal Models", CG&A 2003.
#pragma once

#include <fovea/base/parallel.h>
#include <fovea/path/paths.h>
#include <fovea/scene/tracer.h>
#include <fovea/visibility/runs.h>

namespace fovea::runs {

/// Which surfaces make a run an interior one where they continue behind it.
enum class Inner : std::uint8_t {
    own,     ///< those of its own placement and of its group
    others,  ///< those of the other members of its group
};

struct OuterParts {
    Runs runs;                  ///< the given runs, split
    Array<std::uint8_t> outer;  ///< per run: 1 if what `inner` asks for does not continue behind it
    Array<Index> source;        ///< per run: first point, in Paths, of the segment on which it begins
};

/// Casts rays at the middles of equal parts, at most `step_px` pixels long; a single result between two that agree is
/// replaced by theirs. `sure` (one entry per path of Paths): segments of these kinds are not tested and count as outer.
/// Image-space lines lie on no placement: they must be sure. Throws std::invalid_argument for paths of another scene.
OuterParts outer_parts(const ClippedPaths& clipped, const Paths& paths, const Tracer& tracer, const Runs& runs,
                       In<Kinds> sure, double step_px, const Cancel& cancel, Inner inner = Inner::own);

/// The runs without those parts of contours behind which another placement of the group continues; the same where there
/// are no groups.
Runs without_inner_outlines(const ClippedPaths& clipped, const Paths& paths, const Tracer& tracer, Runs runs,
                            double step_px, const Cancel& cancel);

}  // namespace fovea::runs
