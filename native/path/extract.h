// From a scene and a view to the paths that the line sets ask for.
#pragma once

#include "base/check.h"
#include "base/parallel.h"
#include "path/paths.h"
#include "path/placed_set.h"

namespace fovea {

/// Every edge that a line set finds, once (the first set that finds it has it), chained into paths. What depends on
/// the surface alone is found and chained once and kept with it. Placements outside the frame are left out.
/// Throws std::invalid_argument where line sets or `own` are not of the scene's placements.
Paths extract_paths(const Scene& scene, const View& view, const std::vector<LineSet>& sets, const Tracer& tracer,
                    const Cancel& cancel, const OwnLines& own = {});

}  // namespace fovea
