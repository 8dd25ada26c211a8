// Apparent ridge: a ridge of curvature as it appears in the image.
// Judd, Durand & Adelson, "Apparent Ridges for Line Drawing", SIGGRAPH 2007.
// In   curvature and its derivative, the view
// Out  on the side that faces the viewer, maxima of the greatest view-dependent curvature along its own direction. Near
//      contours, where it grows beyond all bounds, nothing: a contour is drawn there.
#include "line/seen_vertices.h"
#include "line/zero_set.h"

namespace fovea {
namespace {

/// n . v below which a contour is near.
constexpr float contour_near = 0.1f;

Curves find(const SurfaceView& seen, const Values& values) {
    const Surface& surface = seen.surface;
    const auto fields = fields_of(surface);
    const double unit = 1.0 / (double(fields->feature_size) * fields->feature_size);
    const auto threshold = static_cast<float>(values[0] * unit);
    Array<vec3> uphill(surface.vertex_count());
    Array<float> above(uphill.size()), facing(uphill.size());
    parallel_for(uphill.size(), [&](std::size_t v) {
        const Curvature& c = fields->curvature[v];
        const SeenOf<float> s = see_vertex(seen, c, static_cast<Index>(v));
        facing[v] = s.facing;
        if (s.facing <= 0.0f) return;
        const ViewCurvatureOf<float> view = view_curvature(c, s);
        const vec3 along = view.a1 * c.e1 + view.a2 * c.e2;
        uphill[v] = along * (view.derivative / glm::length(along));
        above[v] = view.squared - threshold;
    });
    return trace_maxima(
        surface, facing_above(surface, facing, 0.0f), [&](Index v) { return uphill[v]; }, 0.0f,
        [&](Index v) { return vec2(above[v], facing[v] - contour_near); }, fading(threshold));
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
