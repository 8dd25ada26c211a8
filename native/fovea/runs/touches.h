// SPDX-License-Identifier: GPL-3.0-or-later
// Runs that pass places of the image.
#pragma once

#include <fovea/visibility/runs.h>

namespace fovea::runs {

/// A place in the image, finite.
struct Place {
    dvec2 px;
    Index key;  ///< of the runs that are looked for
};

/// A run passes a place, nearest at an arc length of its piece.
struct Touch {
    Index place, run;
    double distance_px, arc;
    auto operator<=>(const Touch&) const = default;
};

/// The runs within `touch_px` of places: one touch for each place and run, sorted by them. `key`: per run; `none`: it
/// is not looked for. Parallel; the result does not depend on the number of threads.
Array<Touch> touches_of(const ClippedPaths& clipped, const Runs& runs, In<Place> places, In<Index> key,
                        double touch_px);

/// Per place: 1 if a visible run, whatever its key, is within `touch_px` of it, other than the one in `own` (per
/// place). Parallel.
Array<std::uint8_t> touched_by_others(const ClippedPaths& clipped, const Runs& runs, In<Place> places, In<Index> own,
                                      double touch_px);

}  // namespace fovea::runs
