// SPDX-License-Identifier: GPL-3.0-or-later
// For how long each place of a line is seen, while the ends of what is seen move.
#pragma once

#include <vector>

#include <fovea/base/types.h>

namespace fovea::elision {

/// What is seen along a line at one moment.
struct SeenAlong {
    bool first = false;           ///< whether its start is seen
    std::vector<double> changes;  ///< where it is not as before: ascending

    bool at(double place) const;
    /// Continues the line from a place on, to which it is known.
    void go_on(double from, bool seen);
    /// Continues it as another one is between two places.
    void go_on(const SeenAlong& other, double from, double to);

   private:
    bool last_ = false, begun_ = false;
};

/// A part of a line over which a share is linear.
struct Ramp {
    double from, to;
    float at_from, at_to;
};

/// The share of the time from the first moment to the last one for which each place of a line of this length is seen:
/// parts without gaps between them. From one moment to the next, an end of what is seen moves steadily to the nearest
/// one of its kind (from hidden to seen along the line, or from seen to hidden) whose nearest it is, too; what has no
/// such end comes, or goes, half way between the two. Empty if nothing changes: ends that move by less than `still` of
/// the length do not. At least two moments.
std::vector<Ramp> seen_over_time(In<SeenAlong> moments, double length, double still = 1e-6);

}  // namespace fovea::elision
