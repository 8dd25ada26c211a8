// Laplacian line: zero crossings of the Laplacian of shading by a lamp at the eye.
// Zhang et al., "Real-time Feature-based Line Drawing with Laplacian Lines", TVCG 2009.
// In   curvature and its derivative, the view
// Out  on the side that faces the viewer, where the Laplacian of n . v is zero and its gradient above the threshold
#include "line/seen_vertices.h"
#include "line/threshold.h"
#include "line/zero_set.h"

namespace fovea {
namespace {

Curves find(const SurfaceView& seen, const Values& values) {
    const Surface& surface = seen.surface;
    const auto fields = fields_of(surface);
    const Thresholds thresholds(values, 1.0 / fields->feature_size);
    Array<float> value(surface.vertex_count()), above(value.size()), facing(value.size());
    parallel_for(value.size(), [&](std::size_t v) {
        const Curvature& c = fields->curvature[v];
        const SeenOf<float> s = see_vertex(seen, c, static_cast<Index>(v));
        value[v] = laplacian(c, s);
        above[v] = std::sqrt(gradient2(c, s)) - thresholds.low;
        facing[v] = s.facing;
    });
    return trace_zero_set(
        surface, facing_anywhere(surface, facing), [&](Index v) { return value[v]; },
        [&](Index v) { return vec2(above[v], facing[v]); }, fading(thresholds));
}

}  // namespace

extern const LineDefinition laplacian_line;
const LineDefinition laplacian_line = {
    .name = "laplacian_line",
    .label = "Laplacian Line",
    .source = "Zhang et al. 2009",
    .description = "Where shading by a lamp at the eye turns from bright to dark most quickly",
    .scope = Scope::view,
    .parameters = threshold_parameters(
        0.05, 0.5, 2.0, "Gradient of n . v that a line reaches somewhere, in units of 1 / feature size"),
    .on_by_default = false,
    .find = find,
    .select = [](const Surface& surface, const Values& values) {
        return Thresholds(values, 1.0 / fields_of(surface)->feature_size).selection(surface, values);
    },
};

}  // namespace fovea
