// SPDX-License-Identifier: GPL-3.0-or-later
// Shared by ridges and valleys.
#pragma once

#include <fovea/line/threshold.h>
#include <fovea/line/zero_set.h>

namespace fovea::line {

struct CrestValues : ThresholdValues {
    double sharpness, prominence;
};

inline Parameters<CrestValues> crest_parameters() {
    return threshold_parameters<CrestValues>(
               0.1, 0.5, 6.0, "Curvature that a line reaches somewhere, relative to the size of the features")
        .with({{&CrestValues::sharpness, "sharpness", "Sharpness", 0.002, 0.0, 100.0, Unit::none,
                "How steeply curvature falls to both sides of the line at least, relative to the size of the features"},
               {&CrestValues::prominence, "prominence", "Prominence", 0.0, 0.0, 1.0, Unit::none,
                "Least share by which curvature falls to both sides, half a radian of turning away: ripples of tubes "
                "and limbs do not"}});
}

/// The pieces of crests of which curvature, half a radian of turning away from them to both sides (at least two sides
/// of triangles, along straight geodesics), has fallen by at least the share `least`. `sign`: 1 for ridges, -1 for
/// valleys. Sides on which the surface ends do not count.
Curves prominent(const Surface& surface, const Curves& crests, float sign, double least);

/// Crest lines: maxima of sign * k1 along e1 where it is positive. On tubes, spheres and tori curvature hardly changes
/// across such lines, which are noise: the sharpness threshold removes them.
inline Curves find_crests(const SurfaceView& seen, const CrestValues& values, float sign) {
    const Surface& surface = seen.surface;
    const auto fields = fields_of(surface);
    const double unit = 1.0 / fields->feature_size;
    const Thresholds thresholds(surface, values, 1);
    const auto k1 = [&](Index v) { return sign * fields->curvature[v].k1; };
    const auto same_kind = [&](Index t) {
        const Triangle& c = surface.triangles[t];
        return k1(c.x) > 0.0f && k1(c.y) > 0.0f && k1(c.z) > 0.0f;
    };
    const auto uphill = [&](Index v) {
        const Curvature& c = fields->curvature[v];
        return sign * c.C[0] * c.e1;
    };
    const Curves crests = trace_maxima(
        surface, same_kind, uphill, static_cast<float>(values.sharpness * unit * unit * unit),
        [&](Index v) { return k1(v) - thresholds.low; }, thresholds);
    return values.prominence > 0.0 ? prominent(surface, crests, sign, values.prominence) : crests;
}

}  // namespace fovea::line
