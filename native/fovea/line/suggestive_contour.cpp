// SPDX-License-Identifier: GPL-3.0-or-later
// Suggestive contour: contours of nearby views. DeCarlo et al., "Suggestive Contours for Conveying Shape", SIGGRAPH
// 2003.
// In   curvature and its derivative, the view
// Out  on front-facing parts, zeros of the radial curvature where it increases towards the viewer
#include <fovea/line/suggestive.h>

namespace fovea::line {

extern const LineDefinition suggestive_contour = {
    .name = "suggestive_contour",
    .label = "Suggestive Contour",
    .source = "DeCarlo et al. 2003; DeCarlo, Finkelstein & Rusinkiewicz 2004",
    .description = "Where a contour would first appear if the viewer moved a little",
    .scope = Scope::view,
    .importance = 0.3,
    .parameters = suggestive_parameters(0.01),
    .rule = feature_rule(suggestive_parameters(0.01), 2, find_suggestive, 1.0f),
    .usual = true,
    .of_smooth = true,
};

}  // namespace fovea::line
