// SPDX-License-Identifier: GPL-3.0-or-later
// Ridge: a crest line of convex parts.
// Ohtake, Belyaev & Seidel, "Ridge-Valley Lines on Meshes via Implicit Surface Fitting", SIGGRAPH 2004.
// In   curvature and its derivative
// Out  maxima of k1 > 0 along its own direction
#include <fovea/line/crest.h>

namespace fovea {

extern const LineDefinition ridge;
const LineDefinition ridge = {
    .name = "ridge",
    .label = "Ridge",
    .source = "Ohtake, Belyaev & Seidel 2004",
    .description = "Crests of convex parts: where curvature is greatest across the line",
    .scope = Scope::surface,
    .parameters = crest_parameters(),
    .on_by_default = false,
    .find = [](const SurfaceView& seen, const Values& values) { return find_crests(seen, values, 1.0f); },
    .select = select_by_threshold<1>,
};

}  // namespace fovea
