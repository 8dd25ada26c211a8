// SPDX-License-Identifier: GPL-3.0-or-later
#include <fovea/runs/short_hidden.h>

#include <fovea/base/check.h>

namespace fovea {

Runs without_short_hidden(const ClippedPaths& clipped, const Runs& runs, In<float> least_px) {
    check(runs.piece.empty() || runs.piece.back() < clipped.path.size(), "runs: they are not of these clipped paths");
    check(clipped.path.empty() || clipped.path.back() < least_px.size(), "least_px: one value per path expected");
    constexpr double same_place = 1e-6;
    Runs kept;
    for (std::size_t r = 0; r < runs.size();) {
        const Index piece = runs.piece[r];
        std::size_t end = r + 1;
        if (runs.invisibility[r] != 0)
            while (end < runs.size() && runs.piece[end] == piece && runs.invisibility[end] != 0 &&
                   runs.start_px[end] <= runs.end_px[end - 1] + same_place)
                ++end;
        const double first = clipped.arc_px[clipped.pieces.begin(piece)];
        const double last = clipped.arc_px[clipped.pieces.end(piece) - 1];
        const double start = runs.start_px[r], stop = runs.end_px[end - 1];
        const bool whole = start <= first + same_place && stop >= last - same_place;
        if (runs.invisibility[r] == 0 || whole || stop - start >= least_px[clipped.path[piece]])
            for (std::size_t k = r; k < end; ++k)
                kept.push(piece, runs.start_px[k], runs.end_px[k], runs.invisibility[k]);
        r = end;
    }
    return kept;
}

}  // namespace fovea
