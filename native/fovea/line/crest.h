// SPDX-License-Identifier: GPL-3.0-or-later
// What ridges and valleys share.
#pragma once

#include <fovea/line/seen_vertices.h>
#include <fovea/line/threshold.h>
#include <fovea/line/zero_set.h>

namespace fovea {

inline std::vector<Parameter> crest_parameters() {
    auto parameters =
        threshold_parameters(0.1, 0.5, 6.0, "Curvature that a line reaches somewhere, in units of 1 / feature size");
    parameters.push_back(
        {"sharpness", "Sharpness", 0.002, 0.0, 100.0, "",
         "Least second derivative of the curvature across the line, in units of 1 / feature size cubed"});
    return parameters;
}

/// Maxima of sign k1, where it is positive. Where curvature hardly changes across a line, on tubes, spheres and tori,
/// there is no crest but noise: the sharpness.
inline Curves find_crests(const SurfaceView& seen, const Values& values, float sign) {
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
    return trace_maxima(
        surface, same_kind, uphill, static_cast<float>(values[3] * unit * unit * unit),
        [&](Index v) { return k1(v) - thresholds.low; }, fading(thresholds));
}

}  // namespace fovea
