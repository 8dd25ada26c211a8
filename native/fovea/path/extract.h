// SPDX-License-Identifier: GPL-3.0-or-later
// From a scene and a view to the paths that the line sets ask for.
#pragma once

#include <fovea/base/parallel.h>
#include <fovea/path/paths.h>
#include <fovea/path/placed_set.h>

namespace fovea::path {

/// Every edge that a line set finds, once (the first set that finds it has it), chained into paths. What depends on
/// the surface alone is found and chained once and kept with it. Placements outside the frame are left out.
/// Throws std::invalid_argument where line sets or `own` are not of the scene's placements.
Paths extract_paths(const Scene& scene, const View& view, const std::vector<LineSet>& sets, const Tracer& tracer,
                    const Cancel& cancel, const OwnLines& own = {});

}  // namespace fovea::path
