// SPDX-License-Identifier: GPL-3.0-or-later
// Laplacian line: zero crossings of the Laplacian of shading by a lamp at the eye.
// Zhang et al., "Laplacian Lines for Real-Time Shape Illustration", I3D 2009.
// In   curvature and its derivative, the view
// Out  on the side that faces the viewer, where the Laplacian of n . v is zero and its gradient above the threshold
#include <fovea/line/cluster_trace.h>
#include <fovea/line/seen_vertices.h>
#include <fovea/line/threshold.h>

namespace fovea {
namespace {

const auto parameters = threshold_parameters<ThresholdValues>(
    0.05, 0.5, 2.0, "Gradient of n . v that a line reaches somewhere, in units of 1 / feature size");

Curves find(const SurfaceView& seen, const ThresholdValues& values) {
    const Surface& surface = seen.surface;
    const auto fields = fields_of(surface);
    const Thresholds thresholds(surface, values, 1);
    struct Glance {
        float value;
        SeenOf<float> seen;
    };
    const auto glance = [&](Index v) -> Glance {
        const SeenOf<float> s = see_vertex(seen, fields->curvature[v], v);
        return {laplacian(fields->curvature[v], s), s};
    };
    const auto margin = [&](Index v, const Glance& at) {
        return vec2(std::sqrt(gradient2(fields->curvature[v], at.seen)) - thresholds.low, at.seen.facing);
    };
    const auto none_in = [&](const SeenCluster& cluster) {
        return cluster.facing().high <= 0.0f || cluster.bounds().curvature <= 0.9999f * thresholds.low ||
               !cluster.laplacian().may_hold(0.0f);
    };
    const auto front = [](const Glance& a, const Glance& b, const Glance& c) {
        return a.seen.facing > 0.0f || b.seen.facing > 0.0f || c.seen.facing > 0.0f;
    };
    return trace_zero_set(seen, none_in, glance, front, margin, fading(thresholds));
}

}  // namespace

extern const LineDefinition laplacian_line;
const LineDefinition laplacian_line = {
    .name = "laplacian_line",
    .label = "Laplacian Line",
    .source = "Zhang et al. 2009",
    .description = "Where shading by a lamp at the eye turns from bright to dark most quickly",
    .scope = Scope::view,
    .importance = 0.25,
    .parameters = parameters,
    .rule = CurveRule{CurveType::feature, parameters.of(find), parameters.of(select_by_threshold<1>)},
};

}  // namespace fovea
