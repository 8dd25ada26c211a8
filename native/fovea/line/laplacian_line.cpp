// SPDX-License-Identifier: GPL-3.0-or-later
// Laplacian line: zero crossings of the Laplacian of shading by a headlight. Zhang et al., "Laplacian Lines for
// Real-Time Shape Illustration", I3D 2009.
// In   curvature and its derivative, the view
// Out  on front-facing parts, zeros of the Laplacian of n . v where its gradient is above the threshold
#include <fovea/line/cluster_trace.h>
#include <fovea/line/threshold.h>

namespace fovea::line {
namespace {

const auto laplacian_line_parameters = threshold_parameters<ThresholdValues>(
    0.05, 0.5, 2.0, "How quickly shading changes, that a line reaches somewhere, relative to the size of the features");

Curves find_laplacian_line(const SurfaceView& seen, const ThresholdValues& values) {
    const Thresholds thresholds(seen.surface, values, 1);
    const auto value = [](const Curvature& c, const SeenOf<float>& s) { return laplacian(c, s); };
    const auto margin = [&](const Curvature& c, const SeenOf<float>& s) {
        return std::sqrt(gradient2(c, s)) - thresholds.low;
    };
    const auto none_in = [&](const SeenCluster& cluster) {
        return cluster.facing().high <= 0.0f || cluster.bounds().curvature <= 0.9999f * thresholds.low ||
               !cluster.laplacian().may_hold(0.0f);
    };
    return trace_zero_set_in_front(seen, none_in, value, margin, thresholds);
}

}  // namespace

extern const LineDefinition laplacian_line = {
    .name = "laplacian_line",
    .label = "Laplacian Line",
    .source = "Zhang et al. 2009",
    .description = "Where shading by a lamp at the eye turns from bright to dark most quickly",
    .scope = Scope::view,
    .importance = 0.25,
    .parameters = laplacian_line_parameters,
    .rule = feature_rule(laplacian_line_parameters, 1, find_laplacian_line),
    .of_smooth = true,
};

}  // namespace fovea::line
