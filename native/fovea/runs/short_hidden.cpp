// SPDX-License-Identifier: GPL-3.0-or-later
#include <fovea/base/check.h>
#include <fovea/runs/chain.h>
#include <fovea/runs/filters.h>

namespace fovea::runs {

Runs without_short_hidden(const ClippedPaths& clipped, const Runs& runs, In<float> least_px) {
    check_runs(clipped, runs);
    check(clipped.path.empty() || clipped.path.back() < least_px.size(), "least_px: one value per path expected");
    Runs kept;
    for (std::size_t r = 0; r < runs.size();) {
        const Index piece = runs.piece[r];
        std::size_t end = r + 1;
        if (runs.invisibility[r] != 0)
            while (end < runs.size() && runs.piece[end] == piece && runs.invisibility[end] != 0 &&
                   runs.start_px[end] <= runs.end_px[end - 1] + same_place_px)
                ++end;
        const double start = runs.start_px[r], stop = runs.end_px[end - 1];
        const bool whole =
            start <= clipped.first_arc(piece) + same_place_px && stop >= clipped.last_arc(piece) - same_place_px;
        if (runs.invisibility[r] == 0 || whole || stop - start >= least_px[clipped.path[piece]])
            for (std::size_t k = r; k < end; ++k) kept.push(runs, k);
        r = end;
    }
    return kept;
}

}  // namespace fovea::runs
