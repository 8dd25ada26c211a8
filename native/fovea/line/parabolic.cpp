// SPDX-License-Identifier: GPL-3.0-or-later
// Parabolic line: between elliptic and hyperbolic parts of a surface. Koenderink, "What does the occluding contour tell
// us about solid shape?", Perception 1984.
// In   curvature
// Out  zeros of the Gaussian curvature k1 k2 where |k1| is above the threshold
#include <fovea/line/zero_curvature.h>

namespace fovea::line {

extern const LineDefinition parabolic = {
    .name = "parabolic",
    .label = "Parabolic Line",
    .source = "Koenderink 1984; Cole 2009, section 2.2",
    .description = "Between convex or concave and saddle-shaped parts: zero Gaussian curvature",
    .scope = Scope::surface,
    .importance = 0.25,
    .parameters = zero_curvature_parameters(),
    .rule = feature_rule(zero_curvature_parameters(), 1, find_zero_curvature, 1.0f,
                         [](const Curvature& c) { return c.k1 * c.k2; }),
    .of_smooth = true,
};

}  // namespace fovea::line
