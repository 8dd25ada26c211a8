// SPDX-License-Identifier: GPL-3.0-or-later
// What suggestive contours and highlights share.
#pragma once

#include <fovea/line/cluster_trace.h>
#include <fovea/line/seen_vertices.h>
#include <fovea/line/threshold.h>

namespace fovea {

inline Parameters<ThresholdValues> suggestive_parameters(double threshold) {
    return threshold_parameters<ThresholdValues>(threshold, 0.5, 2.0,
                                                 "Strength that a line reaches somewhere: tan(theta) D_W k_r, "
                                                 "in units of 1 / feature size squared");
}

/// Zeros of the radial curvature where it rises along the view (sign 1) or falls (sign -1) by more than the threshold:
/// tan(theta) D_W k_r, on the side that faces the viewer; near contours, where it grows beyond all bounds, it is kept
/// finite.
inline Curves find_suggestive(const SurfaceView& seen, const ThresholdValues& values, float sign) {
    constexpr float least_facing = 0.05f;  // n . v
    const Surface& surface = seen.surface;
    const auto fields = fields_of(surface);
    const Thresholds thresholds(surface, values, 2);
    struct Glance {
        float value;
        SeenOf<float> seen;
    };
    const auto glance = [&](Index v) -> Glance {
        const SeenOf<float> s = see_vertex(seen, fields->curvature[v], v);
        return {radial_scaled(fields->curvature[v], s), s};
    };
    const auto margin = [&](Index v, const Glance& at) {
        const float derivative = radial(fields->curvature[v], at.seen).derivative;
        return vec2(sign * derivative / std::max(at.seen.facing, least_facing) - thresholds.low, at.seen.facing);
    };
    const auto none_in = [&](const SeenCluster& cluster) {
        const Range facing = cluster.facing();
        if (facing.high <= 0.0f || !cluster.radial().may_hold(0.0f)) return true;
        const float turned = std::max(0.0f, sign < 0.0f ? facing.high : -facing.low), k = cluster.bounds().curvature;
        const float most = cluster.bounds().third + 2.0f * turned * k * k;
        return most <= 0.9999f * thresholds.low * std::max(facing.low, least_facing);
    };
    const auto front = [](const Glance& a, const Glance& b, const Glance& c) {
        return a.seen.facing > 0.0f || b.seen.facing > 0.0f || c.seen.facing > 0.0f;
    };
    return trace_zero_set(seen, none_in, glance, front, margin, fading(thresholds));
}

}  // namespace fovea
