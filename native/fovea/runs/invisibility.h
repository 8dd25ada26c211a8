// SPDX-License-Identifier: GPL-3.0-or-later
// Quantitative invisibility: how many surfaces hide a line. Appel, "The Notion of Quantitative Invisibility and the
// Machine Rendering of Solids", ACM National Conference 1967.
#pragma once

#include <fovea/base/parallel.h>
#include <fovea/path/paths.h>
#include <fovea/scene/tracer.h>
#include <fovea/visibility/runs.h>

namespace fovea::runs {

/// `all` (visibility/runs.h, with_hidden) with its hidden runs split where the number of surfaces before them changes,
/// told apart up to `levels` (at most 255): a run's invisibility is the number of surfaces or `levels`, whichever is
/// less, and at least 1. What counts as a surface: Tracer::surfaces_before. Visible runs stay as they are, and so does
/// everything for levels <= 1. One ray per atlas sample counts; each change between two is narrowed to
/// exact_tolerance_px.
Runs count_invisibility(const ClippedPaths& clipped, const Paths& paths, const Tracer& tracer, const Runs& all,
                        Index levels, const Cancel& cancel);

}  // namespace fovea::runs
