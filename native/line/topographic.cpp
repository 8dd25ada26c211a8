// Topographic line: lines of equal distance along the view, like those of a map.
// Cole 2009, section 2.2.
// In   the view
// Out  where the distance along the view is one of so many evenly spaced values over the depth of the surface
#include "line/seen_vertices.h"
#include "line/zero_set.h"

namespace fovea {
namespace {

Curves find(const SurfaceView& seen, const Values& values) {
    const dmat4& m = seen.object_to_view;
    const Array<float> depth = per_vertex(seen, [&](Index v) {
        return static_cast<float>(-(m * dvec4(dvec3(seen.surface.positions[v]), 1.0)).z);
    });
    // Of the sphere around the surface, so that lines do not move with single vertices.
    const dvec3 row(m[0][2], m[1][2], m[2][2]);
    const double middle = -(glm::dot(row, dvec3(seen.surface.center)) + m[3][2]);
    const double reach = glm::length(row) * seen.surface.radius;
    const int count = std::max(1, static_cast<int>(values[0]));
    const double step = 2.0 * reach / (count + 1);
    return trace_levels(seen.surface, [&](Index v) { return depth[v]; }, static_cast<float>(middle - reach),
                        static_cast<float>(step), count);
}

}  // namespace

extern const LineDefinition topographic;
const LineDefinition topographic = {
    .name = "topographic",
    .label = "Topographic Line",
    .source = "Cole 2009, section 2.2",
    .description = "Lines of equal distance along the view, like those of a map",
    .scope = Scope::view,
    .parameters = {{"count", "Count", 20.0, 1.0, 200.0, "", "How many lines over the depth of the object"}},
    .on_by_default = false,
    .find = find,
};

}  // namespace fovea
