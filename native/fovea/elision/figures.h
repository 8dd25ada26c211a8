// SPDX-License-Identifier: GPL-3.0-or-later
// Figures: lines that meet at their ends, like the outlines of letters (runs/groups.h, with whole paths). A small one
// is thinned as a whole: line by line, what is left of it could not be read.
#pragma once

#include <fovea/elision/own_band.h>
#include <fovea/runs/groups.h>

namespace fovea::elision {

/// Fills OwnBands::figure and figure_of_rank. A figure counts as small, with a weight of 1, up to twice the
/// distance that its lines keep from others, and not at all from four times on.
void mark_figures(const Groups& figures, const Runs& runs, In<Index> ranks, OwnBands& own);

}  // namespace fovea::elision
