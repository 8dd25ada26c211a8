// SPDX-License-Identifier: GPL-3.0-or-later
// What lines of zero curvature share.
#pragma once

#include <fovea/line/threshold.h>
#include <fovea/line/zero_set.h>

namespace fovea::line {

inline Parameters<ThresholdValues> zero_curvature_parameters() {
    return threshold_parameters<ThresholdValues>(
        0.02, 0.5, 2.0, "Curvature that a line reaches somewhere, in units of 1 / feature size");
}

/// Where curvature(Curvature) is zero and |k1| above the threshold. Asked of the difference of k1 and k2: |k1| has a
/// crease where they are opposite. `share`: what |k1| is of it on the line.
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
