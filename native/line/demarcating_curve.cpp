// Demarcating curve: where a valley turns into a ridge.
// Kolomenkin, Shimshoni & Tal, "Demarcating Curves for Shape Illustration", SIGGRAPH Asia 2008.
// In   curvature and its derivative
// Out  where the curvature along g, the direction in which curvature changes most, is zero. Triangles whose corners
//      disagree about g by more than 45 degrees have no line: there another maximum takes over.
#include "line/seen_vertices.h"
#include "line/threshold.h"
#include "line/zero_set.h"

namespace fovea {
namespace {

Thresholds thresholds_of(const Surface& surface, const Values& values) {
    const double size = fields_of(surface)->feature_size;
    return {values, 1.0 / (size * size)};
}

Curves find(const SurfaceView& seen, const Values& values) {
    const Surface& surface = seen.surface;
    const auto fields = fields_of(surface, {});
    const Thresholds thresholds = thresholds_of(surface, values);
    Array<vec3> along(surface.vertex_count());
    Array<float> bend(along.size()), above(along.size());
    parallel_for(along.size(), [&](std::size_t v) {
        const Curvature& c = fields->curvature[v];
        const DemarcatingOf<float> d = demarcating(c);
        along[v] = d.g1 * c.e1 + d.g2 * c.e2;
        bend[v] = d.curvature;
        above[v] = d.strength - thresholds.low;
    });
    const auto agreed = [&](Index t) {
        constexpr float cosine = 0.70710678f;
        const Triangle& c = surface.triangles[t];
        return glm::dot(along[c.x], along[c.y]) > cosine && glm::dot(along[c.y], along[c.z]) > cosine &&
               glm::dot(along[c.z], along[c.x]) > cosine;
    };
    return trace_zero_set(surface, agreed, [&](Index v) { return bend[v]; }, [&](Index v) { return above[v]; },
                          fading(thresholds));
}

}  // namespace

extern const LineDefinition demarcating_curve;
const LineDefinition demarcating_curve = {
    .name = "demarcating_curve",
    .label = "Demarcating Curve",
    .source = "Kolomenkin, Shimshoni & Tal 2008",
    .description = "Where a valley turns into a ridge: inflections of the strongest change of curvature",
    .scope = Scope::surface,
    .parameters = threshold_parameters(
        0.02, 0.5, 2.0, "Change of curvature that a line reaches somewhere, in units of 1 / feature size squared"),
    .on_by_default = false,
    .find = find,
    .select = [](const Surface& surface, const Values& values) {
        return thresholds_of(surface, values).selection(surface, values);
    },
};

}  // namespace fovea
