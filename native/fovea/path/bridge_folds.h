// SPDX-License-Identifier: GPL-3.0-or-later
// Folds between the lines of a definition that chooses among the edges of another one.
#pragma once

#include <fovea/line/definition.h>

namespace fovea::path {

/// Sets `bit` on edges between edges that have it, along chains of the edges of `whole` (a definition on mesh edges),
/// where at most 30 reference pixels of the chain lie between them. On a rough mesh the contour doubles back behind its
/// own facets every few edges; those folds are no outline, and would break one into pieces too short to be drawn.
void bridge_folds(const SurfaceView& seen, const LineDefinition& whole, Kinds bit, Array<Kinds>& kinds);

}  // namespace fovea::path
