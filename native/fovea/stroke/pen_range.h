// SPDX-License-Identifier: GPL-3.0-or-later
// Which pen draws a run: by its line set and by how many surfaces hide it.
#pragma once

#include <fovea/visibility/runs.h>

namespace fovea {

/// A pen for the parts of a line set's lines that at least `from` and at most `to` surfaces hide (0: visible parts).
struct PenRange {
    Index line_set, from, to, pen;
};

/// The pen of each run: that of the first range which holds it, `none` where no range does. `line_set`: one entry per
/// path of Paths.
Array<Index> pens_of_runs(const ClippedPaths& clipped, const Runs& runs, In<std::uint8_t> line_set,
                          In<PenRange> ranges);

}  // namespace fovea
