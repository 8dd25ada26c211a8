// SPDX-License-Identifier: GPL-3.0-or-later
// Quantitative invisibility: how many surfaces hide a line. Appel, "The Notion of Quantitative Invisibility and the
// Machine Rendering of Solids", ACM National Conference 1967.
#pragma once

#include <fovea/base/parallel.h>
#include <fovea/path/paths.h>
#include <fovea/scene/tracer.h>
#include <fovea/visibility/runs.h>

namespace fovea::runs {

/// Splits the hidden runs of `all` (visibility/runs.h, with_hidden) where the number of surfaces in front of them
/// changes. The invisibility of a hidden run becomes that number, at least 1 and at most `levels` (<= 255). What counts
/// as a surface: Tracer::surfaces_before. Visible runs are unchanged, and so is everything for levels <= 1. One ray per
/// atlas sample counts; each change between two is narrowed to exact_tolerance_px.
Runs count_invisibility(const ClippedPaths& clipped, const Paths& paths, const Tracer& tracer, const Runs& all,
                        Index levels, const Cancel& cancel);

}  // namespace fovea::runs
