// SPDX-License-Identifier: GPL-3.0-or-later
// Suggestive highlight: the bright partner of suggestive contours.
// DeCarlo & Rusinkiewicz, "Highlight Lines for Conveying Shape", NPAR 2007.
// In   curvature and its derivative, the view
// Out  on the side that faces the viewer, where the radial curvature is zero and falls along the view
#include <fovea/line/suggestive.h>

namespace fovea {
namespace {

const auto parameters = suggestive_parameters(0.02);

Curves find(const SurfaceView& seen, const ThresholdValues& values) { return find_suggestive(seen, values, -1.0f); }

}  // namespace

extern const LineDefinition suggestive_highlight;
const LineDefinition suggestive_highlight = {
    .name = "suggestive_highlight",
    .label = "Suggestive Highlight",
    .source = "DeCarlo & Rusinkiewicz 2007",
    .description =
        "Where the surface is turned most towards the viewer along the view: the bright partner of suggestive contours",
    .scope = Scope::view,
    .importance = 0.25,
    .parameters = parameters,
    .rule = CurveRule{CurveType::feature, parameters.of(find), parameters.of(select_by_threshold<2>)},
};

}  // namespace fovea
