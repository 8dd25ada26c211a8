// SPDX-License-Identifier: GPL-3.0-or-later
// Total order of runs by priority.
#pragma once

#include <fovea/path/paths.h>
#include <fovea/visibility/runs.h>

namespace fovea {

/// Rank of each run, from 1: the higher goes before the lower. Visible runs go before hidden ones; among these, those
/// of paths of higher priority; where that is equal, of lower id, then of lower number. So all visible runs of a path
/// have one rank, all its hidden ones another, and no other path has it. `priority`: per path of Paths; what is not a
/// number comes last. Cole 2009, section 5.2.2.
Array<Index> rank_runs(const ClippedPaths& clipped, const Runs& runs, In<float> priority, In<std::uint64_t> id);

}  // namespace fovea
