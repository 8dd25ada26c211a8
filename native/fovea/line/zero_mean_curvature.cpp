// SPDX-License-Identifier: GPL-3.0-or-later
// Zero mean curvature: where a surface is a saddle with opposite principal curvatures.
// Cole 2009, section 2.2.
// In   curvature
// Out  zeros of k1 + k2 where |k1| is above the threshold
#include <fovea/line/zero_curvature.h>

namespace fovea::line {

extern const LineDefinition zero_mean_curvature = {
    .name = "zero_mean_curvature",
    .label = "Zero Mean Curvature",
    .source = "Cole 2009, section 2.2",
    .description = "Where a surface bends as much one way as the other",
    .scope = Scope::surface,
    .importance = 0.25,
    .parameters = zero_curvature_parameters(),
    .rule = feature_rule(zero_curvature_parameters(), 1, find_zero_curvature, 0.5f,
                         [](const Curvature& c) { return c.k1 + c.k2; }),
    .of_smooth = true,
};

}  // namespace fovea::line
