// SPDX-License-Identifier: GPL-3.0-or-later
// Drafts: silhouettes are found among contours by what lies behind them.
#pragma once

#include <fovea/draw/frame.h>

namespace fovea {

/// Visible runs of a frame parted where they are the outer boundary of their object (Options::outlines), and the pen of
/// each; `none`: it is not drawn. The first pens are those of the line sets.
std::pair<Runs, Array<Index>> outlined(const Frame& frame, const Runs& runs);

}  // namespace fovea
