// SPDX-License-Identifier: GPL-3.0-or-later
// Valley: a crest line of concave parts. Ohtake, Belyaev & Seidel, "Ridge-Valley Lines on Meshes via Implicit Surface
// Fitting", SIGGRAPH 2004.
// In   curvature and its derivative
// Out  maxima of -k1 along e1 where k1 < 0
#include <fovea/line/crest.h>

namespace fovea::line {

extern const LineDefinition valley = {
    .name = "valley",
    .label = "Valley",
    .source = "Ohtake, Belyaev & Seidel 2004",
    .description = "Bottoms of concave parts: where curvature is greatest across the line",
    .scope = Scope::surface,
    .importance = 0.25,
    .parameters = crest_parameters(),
    .rule = feature_rule(crest_parameters(), 1, find_crests, -1.0f),
    .usual = true,
    .of_smooth = true,
};

}  // namespace fovea::line
