// Apparent ridge: a ridge of curvature as it appears in the image.
// Judd, Durand & Adelson, "Apparent Ridges for Line Drawing", SIGGRAPH 2007.
// In   curvature and its derivative, the view
// Out  on the side that faces the viewer, maxima of the greatest view-dependent curvature along its own direction. Near
//      contours, where it grows beyond all bounds, nothing: a contour is drawn there.
#include "line/cluster_trace.h"
#include "line/seen_vertices.h"

namespace fovea {
namespace {

/// n . v below which a contour is near.
constexpr float contour_near = 0.1f;

Curves find(const SurfaceView& seen, const Values& values) {
    const Surface& surface = seen.surface;
    const auto fields = fields_of(surface, {});
    const double unit = 1.0 / (double(fields->feature_size) * fields->feature_size);
    const auto threshold = static_cast<float>(values[0] * unit);
    // Nothing appears more curved than it is by more than 1 / n . v.
    struct Glance {
        SeenOf<float> seen;
        bool may_be_above;
    };
    const auto glance = [&](Index v) -> Glance {
        const Curvature& c = fields->curvature[v];
        const SeenOf<float> s = see_vertex(seen, c, v);
        return {s, c.k1 * c.k1 > 0.9999f * threshold * s.facing * s.facing};
    };
    struct Detail {
        vec3 uphill;
        float margin;
    };
    const auto detail = [&](Index v, const Glance& at) -> Detail {
        const Curvature& c = fields->curvature[v];
        const ViewCurvatureOf<float> view = view_curvature(c, at.seen);
        const vec3 along = view.a1 * c.e1 + view.a2 * c.e2;
        return {along * (view.derivative / glm::length(along)), view.squared - threshold};
    };
    const auto none_in = [&](const SeenCluster& cluster) {
        const Range facing = cluster.facing();
        const float most = cluster.bounds().curvature / std::max(facing.low, contour_near);
        return facing.high <= contour_near || most * most <= 0.9999f * threshold;
    };
    const auto wanted = [](const Glance& a, const Glance& b, const Glance& c) {
        return a.seen.facing > contour_near && b.seen.facing > contour_near && c.seen.facing > contour_near &&
               (a.may_be_above || b.may_be_above || c.may_be_above);
    };
    return trace_maxima(seen, none_in, glance, wanted, detail, 0.0f, fading(threshold));
}

}  // namespace

extern const LineDefinition apparent_ridge;
const LineDefinition apparent_ridge = {
    .name = "apparent_ridge",
    .label = "Apparent Ridge",
    .source = "Judd, Durand & Adelson 2007",
    .description = "Where the surface bends most as the viewer sees it",
    .scope = Scope::view,
    .parameters = {{"threshold", "Threshold", 0.1, 0.0, 100.0, "",
                    "Least squared view-dependent curvature, in units of 1 / feature size squared"}},
    .on_by_default = false,
    .find = find,
};

}  // namespace fovea
