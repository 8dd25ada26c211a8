// SPDX-License-Identifier: GPL-3.0-or-later
// Principal highlight of a valley: the bright line along it. DeCarlo & Rusinkiewicz, "Highlight Lines for Conveying
// Shape", NPAR 2007.
// In   curvature, the view
// Out  on front-facing parts with k1 < 0, zeros of v . e1, where n . v is greatest across the line
#include <fovea/line/principal_highlight.h>

namespace fovea::line {

extern const LineDefinition principal_highlight_valley = {
    .name = "principal_highlight_valley",
    .label = "Principal Highlight, Valley",
    .source = "DeCarlo & Rusinkiewicz 2007",
    .description = "The shine of a valley: where it is turned most towards the viewer across itself",
    .scope = Scope::view,
    .importance = 0.25,
    .parameters = principal_highlight_parameters(),
    .rule = feature_rule(principal_highlight_parameters(), 2, find_principal_highlights, -1.0f),
    .of_smooth = true,
};

}  // namespace fovea::line
