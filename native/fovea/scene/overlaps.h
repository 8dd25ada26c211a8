// SPDX-License-Identifier: GPL-3.0-or-later
// Placements whose boxes meet.
#pragma once

#include <utility>
#include <vector>

#include <fovea/scene/scene.h>

namespace fovea {

/// Pairs (i, j), i < j, of positions in `placements` (indices into the scene) whose boxes along the world's axes meet,
/// ascending. Placements without triangles are in none.
std::vector<std::pair<Index, Index>> overlapping_placements(const Scene& scene, In<Index> placements);

}  // namespace fovea
