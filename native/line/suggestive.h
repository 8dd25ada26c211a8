// What suggestive contours and highlights share.
#pragma once

#include "line/cluster_trace.h"
#include "line/seen_vertices.h"

namespace fovea {

inline std::vector<Parameter> suggestive_parameters(double threshold) {
    return {{"threshold", "Threshold", threshold, 0.0, 10.0, "", "Least strength, in units of the feature size"},
            {"fade", "Fade", 0.03, 0.0, 10.0, "", "How far above the threshold a line has half its strength"}};
}

/// Zeros of the radial curvature where it rises along the view (sign 1) or falls (sign -1) by more than the threshold:
/// tan(theta) D_W k_r, in units of 1 / feature size squared, on the side that faces the viewer. The threshold is asked
/// times n . v, which is finite at contours.
inline Curves find_suggestive(const SurfaceView& seen, const Values& values, float sign) {
    const Surface& surface = seen.surface;
    const auto fields = fields_of(surface, {});
    const double unit = 1.0 / (double(fields->feature_size) * fields->feature_size);
    const auto threshold = static_cast<float>(values[0] * unit);
    struct Glance {
        float value;
        SeenOf<float> seen;
    };
    const auto glance = [&](Index v) -> Glance {
        const SeenOf<float> s = see_vertex(seen, fields->curvature[v], v);
        return {radial_scaled(fields->curvature[v], s), s};
    };
    const auto margin = [&](Index v, const Glance& at) {
        return sign * radial(fields->curvature[v], at.seen).derivative - threshold * at.seen.facing;
    };
    const auto none_in = [&](const SeenCluster& cluster) {
        const Range facing = cluster.facing();
        if (facing.high <= 0.0f || !cluster.radial().may_hold(0.0f)) return true;
        const float torsion = sign < 0.0f ? cluster.bounds().curvature : 0.0f;
        return cluster.bounds().third + 2.0f * facing.high * torsion * torsion <= 0.9999f * threshold * facing.low;
    };
    const auto front = [](const Glance& a, const Glance& b, const Glance& c) {
        return a.seen.facing > 0.0f || b.seen.facing > 0.0f || c.seen.facing > 0.0f;
    };
    return trace_zero_set(seen, none_in, glance, front, margin, fading(values[1] * unit));
}

}  // namespace fovea
