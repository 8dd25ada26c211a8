// SPDX-License-Identifier: GPL-3.0-or-later
#include <fovea/stroke/pen_range.h>

#include <algorithm>

#include <fovea/base/check.h>
#include <fovea/base/parallel.h>

namespace fovea {

Array<Index> pens_of_runs(const ClippedPaths& clipped, const Runs& runs, In<std::uint8_t> line_set,
                          In<PenRange> ranges) {
    check(runs.piece.empty() || runs.piece.back() < clipped.path.size(), "runs: they are not of these clipped paths");
    check(clipped.path.empty() || clipped.path.back() < line_set.size(), "line_set: one value per path expected");
    Array<Index> pens(runs.size(), none);
    parallel_for(runs.size(), [&](std::size_t r) {
        const Index set = line_set[clipped.path[runs.piece[r]]], hidden_by = runs.invisibility[r];
        const auto holds = [&](const PenRange& range) {
            return range.line_set == set && range.from <= hidden_by && hidden_by <= range.to;
        };
        const auto found = std::ranges::find_if(ranges, holds);
        if (found != ranges.end()) pens[r] = found->pen;
    });
    return pens;
}

}  // namespace fovea
