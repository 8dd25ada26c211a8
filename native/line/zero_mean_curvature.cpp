// Zero mean curvature: where a surface bends as much one way as the other.
// Cole 2009, section 2.2.
// In   curvature
// Out  where k1 + k2 is zero and |k1| above the threshold
#include "line/seen_vertices.h"
#include "line/zero_set.h"

namespace fovea {
namespace {

Curves find(const SurfaceView& seen, const Values& values) {
    const auto fields = fields_of(seen.surface, {});
    const auto threshold = static_cast<float>(values[0] / fields->feature_size);
    const auto all = [](Index) { return true; };
    return trace_zero_set(
        seen.surface, all, [&](Index v) { return fields->curvature[v].k1 + fields->curvature[v].k2; },
        [&](Index v) { return std::abs(fields->curvature[v].k1) - threshold; }, fading(threshold));
}

}  // namespace

extern const LineDefinition zero_mean_curvature;
const LineDefinition zero_mean_curvature = {
    .name = "zero_mean_curvature",
    .label = "Zero Mean Curvature",
    .source = "Cole 2009, section 2.2",
    .description = "Where a surface bends as much one way as the other",
    .scope = Scope::surface,
    .parameters = {{"threshold", "Threshold", 0.02, 0.0, 100.0, "", "Least curvature, in units of 1 / feature size"}},
    .on_by_default = false,
    .find = find,
};

}  // namespace fovea
