// What suggestive contours and highlights share.
#pragma once

#include "line/seen_vertices.h"
#include "line/zero_set.h"

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
    const auto fields = fields_of(surface);
    const double unit = 1.0 / (double(fields->feature_size) * fields->feature_size);
    const auto threshold = static_cast<float>(values[0] * unit);
    Array<float> scaled(surface.vertex_count()), above(scaled.size()), facing(scaled.size());
    parallel_for(scaled.size(), [&](std::size_t v) {
        const Curvature& c = fields->curvature[v];
        const SeenOf<float> s = see_vertex(seen, c, static_cast<Index>(v));
        const RadialOf<float> r = radial(c, s);
        scaled[v] = r.scaled;
        facing[v] = s.facing;
        above[v] = sign * r.derivative - threshold * s.facing;
    });
    return trace_zero_set(surface, facing_anywhere(surface, facing), [&](Index v) { return scaled[v]; },
                          [&](Index v) { return vec2(above[v], facing[v]); }, fading(values[1] * unit));
}

}  // namespace fovea
