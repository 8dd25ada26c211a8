// SPDX-License-Identifier: GPL-3.0-or-later
// Folds between the lines of a definition that chooses among the edges of another one.
#pragma once

#include <fovea/line/definition.h>

namespace fovea::path {

/// `edges` (ascending) and those between them along chains of the edges of `whole` (a definition on mesh edges), where
/// at most 30 reference pixels of the chain lie between two. On a rough mesh the contour doubles back behind its own
/// facets every few edges; those folds are no outline, and would break one into pieces too short to be drawn.
Array<Index> bridge_folds(const SurfaceView& seen, const LineDefinition& whole, const Array<Index>& edges);

}  // namespace fovea::path
