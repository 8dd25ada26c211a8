// SPDX-License-Identifier: GPL-3.0-or-later
// Clipping of one segment in homogeneous coordinates.
#pragma once

#include <algorithm>

#include <fovea/base/view.h>

namespace fovea::project {

/// Part of a segment, in fractions of its length in space; empty when begin >= end.
struct ClipRange {
    double begin = 0.0, end = 1.0;
};

inline constexpr int clip_planes = 5;

/// Signed distance (inside positive) to the near plane (0) or a side of the frame widened by `margin` (1 to 4).
inline double plane_distance(int plane, const dvec3& position_view, const dvec4& clip, const View& view,
                             double margin) {
    const double w = clip.w * (1.0 + margin);
    switch (plane) {
        case 0:
            return -position_view.z - view.near_clip;
        case 1:
            return w + clip.x;
        case 2:
            return w - clip.x;
        case 3:
            return w + clip.y;
        default:
            return w - clip.y;
    }
}

/// Liang & Barsky, "A New Concept and Method for Line Clipping", TOG 1984, for one plane, given the signed distances of
/// both ends.
inline void clip_plane(double at_begin, double at_end, ClipRange& range) {
    if (at_begin < 0.0 && at_end < 0.0) {
        range = {1.0, 0.0};
    } else if (at_begin < 0.0) {
        range.begin = std::max(range.begin, at_begin / (at_begin - at_end));
    } else if (at_end < 0.0) {
        range.end = std::min(range.end, at_begin / (at_begin - at_end));
    }
}

/// The part in front of the near plane and inside the widened frame.
inline ClipRange clip_segment(const dvec3& a, const dvec3& b, const dvec4& clip_a, const dvec4& clip_b,
                              const View& view, double margin) {
    ClipRange range;
    for (int plane = 0; plane < clip_planes; ++plane)
        clip_plane(plane_distance(plane, a, clip_a, view, margin), plane_distance(plane, b, clip_b, view, margin),
                   range);
    return range;
}

}  // namespace fovea::project
