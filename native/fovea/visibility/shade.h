// SPDX-License-Identifier: GPL-3.0-or-later
// Runs by the shade of the surface that they lie on.
#pragma once

#include <fovea/path/paths.h>
#include <fovea/scene/shade.h>
#include <fovea/visibility/runs.h>

namespace fovea::visibility {

/// Runs, each of one shade.
struct ShadedRuns {
    Runs runs;
    Array<Shade> shade;
};

/// Cuts runs where their shade changes, to exact_tolerance_px: it is looked at where the atlas has samples. A line is
/// as lit as the faces beside it that face the viewer, or all if none does: lit if one of them is; else in cast shadow,
/// if one of them is. Light contours count as attached, outlines of shadows as cast shadow. Lines that are on no
/// surface are lit. A part shorter than `gap_px` between two of one shade is as they are. `cut`: per path, 0: its runs
/// are left out. `paths`: those that were clipped.
ShadedRuns by_shade(const ClippedPaths& clipped, const Paths& paths, const Scene& scene, const View& view,
                    const Runs& runs, In<std::uint8_t> cut, double gap_px, const Cancel& cancel);

}  // namespace fovea::visibility
