// SPDX-License-Identifier: GPL-3.0-or-later
#include <fovea/line/cluster_trace.h>

namespace fovea::line {

Curves in_order_of_triangles(const std::vector<Array<CurvePiece>>& parts, std::size_t triangles) {
    // Counting sort into buckets of 64 triangles, then a stable sort of each bucket.
    constexpr std::size_t bucket = 64;
    Lists<CurvePiece> pieces = lists_of<CurvePiece>((triangles + bucket - 1) / bucket, [&](const auto& give) {
        for (const auto& part : parts)
            for (const CurvePiece& piece : part) give(piece.triangle / bucket, piece);
    });
    parallel_for(pieces.count(), [&](std::size_t b) {
        if (pieces.size(Index(b)) > 1) std::ranges::stable_sort(pieces[Index(b)], {}, &CurvePiece::triangle);
    });
    return std::move(pieces.values);
}

}  // namespace fovea::line
