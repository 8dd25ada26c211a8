// From a scene and a view to the paths that the line sets ask for.
#pragma once

#include "base/check.h"
#include "base/parallel.h"
#include "line/registry.h"
#include "path/paths.h"

namespace fovea {

/// One of a style's line sets: which definitions with which parameters, and where paths split.
struct LineSet {
    struct Kind {
        Index definition;  ///< index into line_definitions()
        Values values;
    };
    std::vector<Kind> kinds;
    double corner_angle_rad = 1.0;
};

/// Every edge that a line set finds, once (the first set that finds it has it), chained into paths. What depends on
/// the surface alone is found and chained once and kept with it. Placements outside the frame are left out.
Paths extract_paths(const Scene& scene, const View& view, const std::vector<LineSet>& sets, const Tracer& tracer,
                    const Cancel& cancel);

}  // namespace fovea
