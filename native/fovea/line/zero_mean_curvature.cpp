// SPDX-License-Identifier: GPL-3.0-or-later
// Zero mean curvature: where a surface bends as much one way as the other.
// Cole 2009, section 2.2.
// In   curvature
// Out  where k1 + k2 is zero and |k1| above the threshold
#include <fovea/line/zero_curvature.h>

namespace fovea {
namespace {

const auto parameters = zero_curvature_parameters();

Curves find(const SurfaceView& seen, const ThresholdValues& values) {
    return find_zero_curvature(seen, values, 0.5f, [](const Curvature& c) { return c.k1 + c.k2; });
}

}  // namespace

extern const LineDefinition zero_mean_curvature;
const LineDefinition zero_mean_curvature = {
    .name = "zero_mean_curvature",
    .label = "Zero Mean Curvature",
    .source = "Cole 2009, section 2.2",
    .description = "Where a surface bends as much one way as the other",
    .scope = Scope::surface,
    .importance = 0.25,
    .parameters = parameters,
    .rule = CurveRule{CurveType::feature, parameters.of(find), parameters.of(select_by_threshold<1>)},
};

}  // namespace fovea
