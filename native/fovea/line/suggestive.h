// SPDX-License-Identifier: GPL-3.0-or-later
// Shared by suggestive contours and suggestive highlights.
#pragma once

#include <fovea/line/cluster_trace.h>
#include <fovea/line/threshold.h>

namespace fovea::line {

inline Parameters<ThresholdValues> suggestive_parameters(double threshold) {
    return threshold_parameters<ThresholdValues>(threshold, 0.5, 2.0,
                                                 "How clearly the surface begins to turn away, that a line reaches "
                                                 "somewhere, relative to the size of the features");
}

/// Zeros of the radial curvature on front-facing parts where sign * tan(theta) D_w k_r exceeds the threshold: the
/// radial curvature increases (sign 1) or decreases (sign -1) towards the viewer. n . v is clamped from below in
/// tan(theta), which is unbounded at contours.
inline Curves find_suggestive(const SurfaceView& seen, const ThresholdValues& values, float sign) {
    constexpr float least_facing = 0.05f;  // n . v
    const Thresholds thresholds(seen.surface, values, 2);
    const auto value = [](const Curvature& c, const SeenOf<float>& s) { return radial_scaled(c, s); };
    const auto margin = [&](const Curvature& c, const SeenOf<float>& s) {
        return sign * radial(c, s).derivative / std::max(s.facing, least_facing) - thresholds.low;
    };
    const auto none_in = [&](const SeenCluster& cluster) {
        const Range facing = cluster.facing();
        if (facing.high <= 0.0f || !cluster.radial().may_hold(0.0f)) return true;
        const float turned = std::max(0.0f, sign < 0.0f ? facing.high : -facing.low), k = cluster.bounds().curvature;
        const float most = cluster.bounds().third + 2.0f * turned * k * k;
        return most <= 0.9999f * thresholds.low * std::max(facing.low, least_facing);
    };
    return trace_zero_set_in_front(seen, none_in, value, margin, thresholds);
}

}  // namespace fovea::line
