// What suggestive contours and highlights share.
#pragma once

#include "line/seen_vertices.h"
#include "line/threshold.h"
#include "line/zero_set.h"

namespace fovea {

inline std::vector<Parameter> suggestive_parameters(double threshold) {
    return threshold_parameters(threshold, 0.5, 2.0,
                                "Strength that a line reaches somewhere: tan(theta) D_W k_r, "
                                "in units of 1 / feature size squared");
}

inline Thresholds suggestive_thresholds(const Surface& surface, const Values& values) {
    const double size = fields_of(surface)->feature_size;
    return {values, 1.0 / (size * size)};
}

inline Selection select_suggestive(const Surface& surface, const Values& values) {
    return suggestive_thresholds(surface, values).selection(surface, values);
}

/// Zeros of the radial curvature where it rises along the view (sign 1) or falls (sign -1) by more than the threshold:
/// tan(theta) D_W k_r, on the side that faces the viewer; near contours, where it
/// grows beyond all bounds, it is kept finite.
inline Curves find_suggestive(const SurfaceView& seen, const Values& values, float sign) {
    constexpr float least_facing = 0.05f;  // n . v
    const Surface& surface = seen.surface;
    const auto fields = fields_of(surface);
    const Thresholds thresholds = suggestive_thresholds(surface, values);
    Array<float> scaled(surface.vertex_count()), above(scaled.size()), facing(scaled.size());
    parallel_for(scaled.size(), [&](std::size_t v) {
        const Curvature& c = fields->curvature[v];
        const SeenOf<float> s = see_vertex(seen, c, static_cast<Index>(v));
        const RadialOf<float> r = radial(c, s);
        scaled[v] = r.scaled;
        facing[v] = s.facing;
        above[v] = sign * r.derivative / std::max(s.facing, least_facing) - thresholds.low;
    });
    return trace_zero_set(surface, facing_anywhere(surface, facing), [&](Index v) { return scaled[v]; },
                          [&](Index v) { return vec2(above[v], facing[v]); }, fading(thresholds));
}

}  // namespace fovea
