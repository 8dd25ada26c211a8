// Apparent ridge: a ridge of curvature as it appears in the image.
// Judd, Durand & Adelson, "Apparent Ridges for Line Drawing", SIGGRAPH 2007.
// In   curvature and its derivative, the view
// Out  on the side that faces the viewer, maxima of the greatest view-dependent curvature along its own direction. Near
//      contours, where it grows beyond all bounds, nothing: a contour is drawn there.
#include "line/seen_vertices.h"
#include "line/threshold.h"
#include "line/zero_set.h"

namespace fovea {
namespace {

/// n . v below which a contour is near.
constexpr float contour_near = 0.1f;

Thresholds thresholds_of(const Surface& surface, const Values& values) {
    const double size = fields_of(surface)->feature_size;
    return {values, 1.0 / (size * size)};
}

std::vector<Parameter> parameters() {
    auto all = threshold_parameters(
        0.1, 0.5, 3.0,
        "Squared view-dependent curvature that a line reaches somewhere, in units of 1 / feature size squared");
    all.push_back({"ridges", "Ridges", 1, 0, 1, "bool", "Draw lines where the surface bulges across them"});
    all.push_back({"valleys", "Valleys", 1, 0, 1, "bool", "Draw lines where the surface is hollow across them"});
    return all;
}

Curves find(const SurfaceView& seen, const Values& values) {
    const Surface& surface = seen.surface;
    const auto fields = fields_of(surface);
    const Thresholds thresholds = thresholds_of(surface, values);
    const bool ridges = values[3] != 0.0, valleys = values[4] != 0.0;
    Array<vec3> uphill(surface.vertex_count());
    Array<float> above(uphill.size()), bend(uphill.size()), facing(uphill.size());
    parallel_for(uphill.size(), [&](std::size_t v) {
        const Curvature& c = fields->curvature[v];
        const SeenOf<float> s = see_vertex(seen, c, static_cast<Index>(v));
        facing[v] = s.facing;
        if (s.facing <= 0.0f) return;
        const ViewCurvatureOf<float> view = view_curvature(c, s);
        const vec3 along = view.a1 * c.e1 + view.a2 * c.e2;
        uphill[v] = along * (view.derivative / glm::length(along));
        above[v] = view.squared - thresholds.low;
        bend[v] = c.k1 * view.a1 * view.a1 + c.k2 * view.a2 * view.a2;
    });
    const auto in_front = facing_above(surface, facing, 0.0f);
    const auto wanted = [&](Index t) {
        if (!in_front(t)) return false;
        const Triangle& corners = surface.triangles[t];
        return bend[corners.x] + bend[corners.y] + bend[corners.z] >= 0.0f ? ridges : valleys;
    };
    return trace_maxima(
        surface, wanted, [&](Index v) { return uphill[v]; }, 0.0f,
        [&](Index v) { return vec2(above[v], facing[v] - contour_near); }, fading(thresholds));
}

}  // namespace

extern const LineDefinition apparent_ridge;
const LineDefinition apparent_ridge = {
    .name = "apparent_ridge",
    .label = "Apparent Ridge",
    .source = "Judd, Durand & Adelson 2007",
    .description = "Where the surface bends most as the viewer sees it",
    .scope = Scope::view,
    .parameters = parameters(),
    .on_by_default = false,
    .find = find,
    .select = [](const Surface& surface, const Values& values) {
        return thresholds_of(surface, values).selection(surface, values);
    },
};

}  // namespace fovea
