// SPDX-License-Identifier: GPL-3.0-or-later
// Takes folds out of contours along mesh edges, so that each is one run, and one stroke.
#pragma once

#include <fovea/visibility/runs.h>

namespace fovea::runs {

/// Paths without their folds, and the visible runs on them. Pieces keep their numbers; arc lengths are kept in the
/// middle of a path.
struct Unfolded {
    ClippedPaths clipped;
    Runs runs;
    Array<Index> sample;  ///< per sample of `clipped`: its number before
};

/// The contour of a rough mesh doubles back behind its own facets every few edges, and is visible between these folds;
/// consecutive visible runs of a path cross, or lie side by side, where the outline goes on from one to the other. On
/// paths with `of_view` set (one entry per path of Paths), joins two runs, between which at most `fold_px` are hidden,
/// at the places at most `fold_px` from their facing ends that are closest to each other, if these are closer than
/// `near_px`, no more of them is cut off than is hidden, only spurs of that lead away, and the line does not turn back
/// there; what lies between is taken out. A run shorter than `spur_px` that meets neither neighbor is passed over.
/// `visible`: runs of invisibility 0. Parallel; the result does not depend on the number of threads. Cf. Northrup &
/// Markosian, "Artistic Silhouettes: A Hybrid Approach", NPAR 2000.
Unfolded join_folds(const ClippedPaths& clipped, const Runs& visible, In<std::uint8_t> of_view, double fold_px,
                    double near_px, double spur_px);

}  // namespace fovea::runs
