// SPDX-License-Identifier: GPL-3.0-or-later
// Clipping of one segment in homogeneous coordinates.
#pragma once

#include <fovea/base/interval.h>
#include <fovea/base/view.h>

namespace fovea::project {

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

/// The part in front of the near plane and inside the widened frame, in fractions of the length in space.
inline Interval clip_segment(const dvec3& a, const dvec3& b, const dvec4& clip_a, const dvec4& clip_b, const View& view,
                             double margin) {
    Interval range = whole_segment;
    for (int plane = 0; plane < clip_planes; ++plane)
        clip_plane(plane_distance(plane, a, clip_a, view, margin), plane_distance(plane, b, clip_b, view, margin),
                   range);
    return range;
}

}  // namespace fovea::project
