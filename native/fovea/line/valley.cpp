// SPDX-License-Identifier: GPL-3.0-or-later
// Valley: a crest line of concave parts.
// Ohtake, Belyaev & Seidel, "Ridge-Valley Lines on Meshes via Implicit Surface Fitting", SIGGRAPH 2004.
// In   curvature and its derivative
// Out  maxima of -k1 > 0 along its own direction
#include <fovea/line/crest.h>

namespace fovea {
namespace {

const auto parameters = crest_parameters();

Curves find(const SurfaceView& seen, const CrestValues& values) { return find_crests(seen, values, -1.0f); }

}  // namespace

extern const LineDefinition valley;
const LineDefinition valley = {
    .name = "valley",
    .label = "Valley",
    .source = "Ohtake, Belyaev & Seidel 2004",
    .description = "Bottoms of concave parts: where curvature is greatest across the line",
    .scope = Scope::surface,
    .importance = 0.25,
    .parameters = parameters,
    .rule = CurveRule{CurveType::feature, parameters.of(find), parameters.of(select_by_threshold<1>)},
};

}  // namespace fovea
