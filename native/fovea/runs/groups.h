// SPDX-License-Identifier: GPL-3.0-or-later
// Groups: visible runs that meet at the ends of their lines, like the outline of a letter.
#pragma once

#include <fovea/visibility/runs.h>

namespace fovea::runs {

struct Groups {
    Array<Index> of_run;         ///< per run: its group, numbered from 0; `none`: hidden, or an image-space line
    Array<float> size_px;        ///< per group: larger side of the box around its runs [px]
    Array<float> length_px;      ///< per group: of its runs together [px]
    Array<std::uint8_t> hidden;  ///< per group: 1 where one of its runs ends because a surface hides its line

    Index count() const { return Index(size_px.size()); }
};

/// Runs whose ends are ends of their paths, at the same point of the same `placement` (per path of Paths), belong to
/// one group; with `whole_paths`, so do all visible runs of a path.
Groups group_runs(const ClippedPaths& clipped, const Runs& runs, In<Index> placement, bool whole_paths);

}  // namespace fovea::runs
