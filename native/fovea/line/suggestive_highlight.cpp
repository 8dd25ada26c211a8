// SPDX-License-Identifier: GPL-3.0-or-later
// Suggestive highlight: the bright counterpart of suggestive contours. DeCarlo & Rusinkiewicz, "Highlight Lines for
// Conveying Shape", NPAR 2007.
// In   curvature and its derivative, the view
// Out  on front-facing parts, zeros of the radial curvature where it decreases towards the viewer
#include <fovea/line/suggestive.h>

namespace fovea::line {

extern const LineDefinition suggestive_highlight = {
    .name = "suggestive_highlight",
    .label = "Suggestive Highlight",
    .source = "DeCarlo & Rusinkiewicz 2007",
    .description =
        "Where the surface is turned most towards the viewer along the view: the bright partner of suggestive contours",
    .scope = Scope::view,
    .importance = 0.25,
    .parameters = suggestive_parameters(0.01),
    .rule = feature_rule(suggestive_parameters(0.01), 2, find_suggestive, -1.0f),
    .of_smooth = true,
};

}  // namespace fovea::line
