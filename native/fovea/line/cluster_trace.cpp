// SPDX-License-Identifier: GPL-3.0-or-later
#include <fovea/line/cluster_trace.h>

namespace fovea {

Curves in_order_of_triangles(const std::vector<std::vector<CurvePiece>>& parts, std::size_t triangles) {
    // Into buckets of a few triangles by counting, then each by itself.
    constexpr std::size_t bucket = 64;
    Rows rows;
    rows.offsets.assign((triangles + bucket - 1) / bucket, 0);
    for (const auto& part : parts)
        for (const CurvePiece& piece : part) ++rows.offsets[piece.triangle / bucket];
    counts_to_offsets(rows.offsets);
    Curves curves(rows.offsets.back());
    Array<Index> next(rows.offsets.begin(), rows.offsets.end() - 1);
    for (const auto& part : parts)
        for (const CurvePiece& piece : part) curves[next[piece.triangle / bucket]++] = piece;
    parallel_for(rows.count(), [&](std::size_t b) {
        if (rows.size(Index(b)) > 1)
            std::stable_sort(curves.begin() + rows.begin(Index(b)), curves.begin() + rows.end(Index(b)),
                             [](const CurvePiece& x, const CurvePiece& y) { return x.triangle < y.triangle; });
    });
    return curves;
}

}  // namespace fovea
