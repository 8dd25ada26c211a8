// SPDX-License-Identifier: GPL-3.0-or-later
// Shared by parabolic lines and lines of zero mean curvature.
#pragma once

#include <fovea/line/threshold.h>
#include <fovea/line/zero_set.h>

namespace fovea::line {

inline Parameters<ThresholdValues> zero_curvature_parameters() {
    return threshold_parameters<ThresholdValues>(
        0.02, 0.5, 2.0, "Curvature that a line reaches somewhere, in units of 1 / feature size");
}

/// Zeros of curvature(Curvature) where |k1| is above the threshold. There, |k1| = share * |k1 - k2|; the difference is
/// used because |k1| itself is not smooth where k1 = -k2.
inline constexpr auto find_zero_curvature = [](const SurfaceView& seen, const ThresholdValues& values, float share,
                                               const auto& curvature) {
    const auto fields = fields_of(seen.surface);
    const Thresholds thresholds(seen.surface, values, 1);
    return trace_zero_set(
        seen.surface, [&](Index v) { return curvature(fields->curvature[v]); },
        [&](Index v) { return share * std::abs(fields->curvature[v].k1 - fields->curvature[v].k2) - thresholds.low; },
        thresholds);
};

}  // namespace fovea::line
