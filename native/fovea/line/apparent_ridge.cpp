// SPDX-License-Identifier: GPL-3.0-or-later
// Apparent ridge: a crest of curvature as it appears in the image. Judd, Durand & Adelson, "Apparent Ridges for Line
// Drawing", SIGGRAPH 2007.
// In   curvature and its derivative, the view
// Out  on front-facing parts, maxima of the maximum view-dependent curvature along its principal direction. None near
//      contours (n . v < 0.1), where that curvature is unbounded and a contour is drawn anyway.
#include <fovea/line/cluster_trace.h>
#include <fovea/line/threshold.h>

namespace fovea::line {
namespace {

/// n . v below which there are no apparent ridges.
constexpr float contour_near = 0.1f;
/// Lower clamp of n . v in view_curvature.
constexpr float least_facing = 1e-3f;

struct ApparentRidge : ThresholdValues {
    bool ridges, valleys;
};

const auto apparent_ridge_parameters =
    threshold_parameters<ApparentRidge>(
        0.025, 0.5, 3.0,
        "Squared view-dependent curvature that a line reaches somewhere, in units of 1 / feature size squared")
        .with({{&ApparentRidge::ridges, "ridges", "Ridges", true, "Draw lines where the surface bulges across them"},
               {&ApparentRidge::valleys, "valleys", "Valleys", true,
                "Draw lines where the surface is hollow across them"}});

Curves find_apparent_ridge(const SurfaceView& seen, const ApparentRidge& values) {
    const Surface& surface = seen.surface;
    const auto fields = fields_of(surface);
    const Thresholds thresholds(surface, values, 2);
    // View-dependent curvature is at most |k1| / (n . v).
    struct VertexEval {
        SeenOf<float> seen;
        bool may_be_above;
    };
    const auto eval = [&](Index v) -> VertexEval {
        const Curvature& c = fields->curvature[v];
        const SeenOf<float> s = see_vertex(seen, c, v);
        return {s, c.k1 * c.k1 > 0.9999f * thresholds.low * s.facing * s.facing};
    };
    struct Detail {
        vec3 uphill;
        float bend;
        vec2 margin;
    };
    const auto detail = [&](Index v, const VertexEval& at) -> Detail {
        const Curvature& c = fields->curvature[v];
        const ViewCurvatureOf<float> view = view_curvature(c, at.seen, least_facing);
        const vec3 along = view.a1 * c.e1 + view.a2 * c.e2;
        return {along * (view.derivative / glm::length(along)), c.k1 * view.a1 * view.a1 + c.k2 * view.a2 * view.a2,
                vec2(view.squared - thresholds.low, at.seen.facing - contour_near)};
    };
    const auto none_in = [&](const SeenCluster& cluster) {
        const Range facing = cluster.facing();
        const float most = cluster.bounds().curvature / std::max(facing.low, least_facing);
        return facing.high <= contour_near || most * most <= 0.9999f * thresholds.low;
    };
    const auto wanted = [](const VertexEval& a, const VertexEval& b, const VertexEval& c) {
        return a.seen.facing > 0.0f && b.seen.facing > 0.0f && c.seen.facing > 0.0f &&
               (a.may_be_above || b.may_be_above || c.may_be_above);
    };
    const auto sides = triangle_sides(surface);
    return trace_clusters(seen, none_in, eval, wanted, detail,
                          [&](Index triangle, const auto&, const auto& at, auto& out) {
                              const Triangle& t = surface.triangles[triangle];
                              const bool bulges = at(t.x).bend + at(t.y).bend + at(t.z).bend >= 0.0f;
                              if (bulges ? !values.ridges : !values.valleys) return;
                              append_maximum(
                                  surface, *sides, triangle, [&](Index v) { return at(v).uphill; }, 0.0f,
                                  [&](Index v) { return at(v).margin; }, thresholds, out);
                          });
}

}  // namespace

extern const LineDefinition apparent_ridge = {
    .name = "apparent_ridge",
    .label = "Apparent Ridge",
    .source = "Judd, Durand & Adelson 2007",
    .description = "Where the surface bends most as the viewer sees it",
    .scope = Scope::view,
    .importance = 0.3,
    .parameters = apparent_ridge_parameters,
    .rule = feature_rule(apparent_ridge_parameters, 2, find_apparent_ridge),
    .of_smooth = true,
};

}  // namespace fovea::line
