// SPDX-License-Identifier: GPL-3.0-or-later
// Shared by smooth contours and smooth silhouettes.
#pragma once

#include <fovea/line/cluster_trace.h>

namespace fovea::line {

/// Strength at which a closed surface begins to hide its own contour, at cusps, and how much less is certain.
inline constexpr float at_cusp = 0.5f, surely = 0.1f;

/// Strength of contours, in (0, 1]: by the radial curvature where a closed part of a surface hides its own contours
/// behind cusps, elsewhere 1. Refers to the view of the surface.
class CuspStrength {
   public:
    explicit CuspStrength(const SurfaceView& seen);
    float operator()(Index vertex) const;

   private:
    const SurfaceView& seen_;
    std::shared_ptr<const Array<std::uint8_t>> hides_;  // per vertex; null: nowhere
    std::shared_ptr<const Fields> fields_;
};

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
