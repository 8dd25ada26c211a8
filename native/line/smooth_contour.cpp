// Smooth contour: the contour of the surface that the mesh stands for, across its triangles.
// Hertzmann & Zorin, "Illustrating Smooth Surfaces", SIGGRAPH 2000, section 4.
// In   normals of the fitted surface (those of the mesh alone are too rough on irregular triangles), the view
// Out  where the interpolated n . v is zero
#include "line/cluster_trace.h"

namespace fovea {
namespace {

Curves find(const SurfaceView& seen, const Values&) {
    const auto fields = fields_of(seen.surface, {});
    struct Glance {
        float value;
    };
    const auto glance = [&](Index v) { return Glance{glm::dot(fields->curvature[v].normal, seen.to_viewer(v))}; };
    const auto none_in = [](const SeenCluster& cluster) { return !cluster.facing().may_hold(0.0f); };
    const auto all = [](Glance, Glance, Glance) { return true; };
    const auto always = [](auto...) { return 1.0f; };
    return trace_zero_set(seen, none_in, glance, all, always, always);
}

}  // namespace

extern const LineDefinition smooth_contour;
const LineDefinition smooth_contour = {
    .name = "smooth_contour",
    .label = "Smooth Contour",
    .source = "Hertzmann & Zorin 2000, section 4; Cole 2009, section 2.2",
    .description = "The contour of the smooth surface that a mesh stands for, across its faces",
    .scope = Scope::view,
    .parameters = {},
    .on_by_default = false,
    .find = find,
};

}  // namespace fovea
