// SPDX-License-Identifier: GPL-3.0-or-later
// Extraction of the paths that line sets request from a scene and a view.
#pragma once

#include <fovea/base/parallel.h>
#include <fovea/path/paths.h>
#include <fovea/path/placed_set.h>

namespace fovea::path {

/// Paths of all line sets. An edge found by several sets belongs to the first. View-independent lines are found and
/// chained once and cached with the surface. Placements outside the frame are skipped. `own`: per-placement overrides.
/// `least_px`: paths of one segment that is no longer in the image are left out (append.h), as project() drops those no
/// longer than a sample. Throws std::invalid_argument if line sets or `own` do not match the number of placements.
Paths extract_paths(const Scene& scene, const View& view, const std::vector<LineSet>& sets, const Tracer& tracer,
                    const Cancel& cancel, const OwnLines& own = {}, double least_px = 0.0);

}  // namespace fovea::path
