// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>

#include <fovea/base/check.h>
#include <fovea/path/paths.h>
#include <fovea/runs/chain.h>
#include <fovea/runs/filters.h>

namespace fovea::runs {
namespace {

/// New end of a contour's run that ends at `end`: the start of the fold, if one lies within fold_px; `way` (+1 or -1):
/// direction of the end along the piece.
double trim_end(const ClippedPaths& clipped, Index piece, double start, double end, int way, double fold_px) {
    constexpr double before_px = 4.0, least_px = 1.0, cosine = -0.87;  // cosine: reversal within 30 degrees
    double result = end;
    const vec2 tip = clipped.place_px(piece, end);
    const auto arcs = clipped.arc_px.begin();
    const double low = way > 0 ? end - fold_px : end, high = way > 0 ? end : end + fold_px;
    const auto first =
        std::lower_bound(arcs + clipped.pieces.begin(piece), arcs + clipped.pieces.end(piece), low) - arcs;
    for (auto i = static_cast<Index>(first); i < clipped.pieces.end(piece) && clipped.arc_px[i] <= high; ++i) {
        const double arc = clipped.arc_px[i], left = (end - arc) * way;
        if (left <= 0.0 || left > fold_px || (arc - start) * way <= before_px || left <= (end - result) * way) continue;
        const vec2 onward = clipped.px[i] - clipped.place_px(piece, arc - way * before_px), rest = tip - clipped.px[i];
        const double lengths = glm::length(onward) * glm::length(rest);
        if (glm::length(rest) > least_px && glm::dot(onward, rest) < cosine * lengths) result = arc;
    }
    return result;
}

}  // namespace

Runs trim_folds(const ClippedPaths& clipped, const Runs& runs, In<std::uint8_t> of_view, double fold_px) {
    check_runs(clipped, runs);
    check(clipped.path.empty() || clipped.path.back() < of_view.size(), "of_view: one value per path expected");
    Runs trimmed = runs;
    const std::size_t count = runs.piece.size();
    parallel_for(count, [&](std::size_t r) {
        const Index piece = runs.piece[r];
        if (!of_view[clipped.path[piece]] || runs.invisibility[r] != 0) return;
        double start = runs.start_px[r], end = runs.end_px[r];
        const bool cusps = of_view[clipped.path[piece]] == ends_at_cusps && !clipped.closed[piece];
        if (cusps || end < clipped.last_arc(piece) - same_place_px)
            end = trim_end(clipped, piece, start, end, 1, fold_px);
        if (cusps || start > clipped.first_arc(piece) + same_place_px)
            start = trim_end(clipped, piece, end, start, -1, fold_px);
        trimmed.start_px[r] = start;
        trimmed.end_px[r] = end;
    });
    return trimmed;
}

}  // namespace fovea::runs
