// SPDX-License-Identifier: GPL-3.0-or-later
// Part of a segment.
#pragma once

#include <algorithm>

namespace fovea::base {

/// From and to which fraction of its length; empty when begin > end.
struct Interval {
    double begin = 1.0, end = 0.0;

    bool is_empty() const { return begin > end; }
    bool holds(double t) const { return begin <= t && t <= end; }
};

inline constexpr Interval whole_segment{0.0, 1.0};

/// Liang & Barsky, "A New Concept and Method for Line Clipping", TOG 1984, for one plane, given the signed distances of
/// both ends, which are positive inside.
inline void clip_plane(double at_begin, double at_end, Interval& range) {
    if (at_begin < 0.0 && at_end < 0.0) {
        range = {};
    } else if (at_begin < 0.0) {
        range.begin = std::max(range.begin, at_begin / (at_begin - at_end));
    } else if (at_end < 0.0) {
        range.end = std::min(range.end, at_begin / (at_begin - at_end));
    }
}

}  // namespace fovea::base
