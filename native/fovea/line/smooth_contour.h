// SPDX-License-Identifier: GPL-3.0-or-later
// Shared by smooth contours and smooth silhouettes.
#pragma once

#include <fovea/line/cluster_trace.h>

namespace fovea::line {

/// Zeros of the interpolated n . v, with the normals n of the fitted surface. strength(v) is interpolated along them.
template <typename Strength>
Curves find_smooth_contour(const SurfaceView& seen, const Strength& strength) {
    const auto fields = fields_of(seen.surface);
    struct VertexEval {
        float value;
    };
    const auto eval = [&](Index v) { return VertexEval{glm::dot(fields->curvature[v].normal, seen.to_viewer(v))}; };
    const auto none_in = [](const SeenCluster& cluster) { return !cluster.facing().may_hold(0.0f); };
    const auto all = [](VertexEval, VertexEval, VertexEval) { return true; };
    const auto margin = [&](Index v, VertexEval) { return strength(v); };
    return trace_zero_set(seen, none_in, eval, all, margin, [](float s) { return s; });
}

}  // namespace fovea::line
