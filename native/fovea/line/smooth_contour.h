// SPDX-License-Identifier: GPL-3.0-or-later
// What smooth contours and smooth silhouettes share.
#pragma once

#include <fovea/line/cluster_trace.h>

namespace fovea::line {

/// Zeros of the interpolated n . v, n the normals of the fitted surface; strength(v) at the vertices is interpolated.
template <typename Strength>
Curves find_smooth_contour(const SurfaceView& seen, const Strength& strength) {
    const auto fields = fields_of(seen.surface);
    struct Glance {
        float value;
    };
    const auto glance = [&](Index v) { return Glance{glm::dot(fields->curvature[v].normal, seen.to_viewer(v))}; };
    const auto none_in = [](const SeenCluster& cluster) { return !cluster.facing().may_hold(0.0f); };
    const auto all = [](Glance, Glance, Glance) { return true; };
    const auto margin = [&](Index v, Glance) { return strength(v); };
    return trace_zero_set(seen, none_in, glance, all, margin, [](float s) { return s; });
}

}  // namespace fovea::line
