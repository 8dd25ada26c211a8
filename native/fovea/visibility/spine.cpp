// SPDX-License-Identifier: GPL-3.0-or-later
#include <fovea/visibility/spine.h>

#include <algorithm>

#include <fovea/visibility/layout.h>

namespace fovea::visibility {

Runs whole_pieces(const ClippedPaths& clipped) {
    Runs runs;
    for (Index q = 0; q < clipped.pieces.count(); ++q)
        if (clipped.pieces.size(q) > 1) runs.push(q, clipped.first_arc(q), clipped.last_arc(q));
    return runs;
}

SpineTest::SpineTest(const ClippedPaths& clipped, const OwnSides& sides, const DepthBuffer& buffer,
                     const SampledOptions& options)
    : clipped_(clipped), sides_(sides), buffer_(buffer), options_(options) {
    check_sides(clipped, sides, "spine test");
    check_sampled(buffer, options);
}

float SpineTest::visibility(Index piece, float u) const {
    // The last segment that starts at or before u; arc lengths are rounded to float as in spine_table.
    const auto arcs = clipped_.arc_px.begin();
    const auto after =
        std::partition_point(arcs + clipped_.pieces.begin(piece) + 1, arcs + clipped_.pieces.end(piece) - 1,
                             [&](double arc) { return float(arc) <= u; });
    const Index segment = Index(after - arcs) - 1;
    const float start = float(after[-1]), length = float(after[0]) - start;
    if (!(length > 0.0f)) return visibility_between(clipped_, sides_, segment, 0.0f, 0.0f, buffer_, options_);
    const float t0 = std::clamp((u - 0.5f - start) / length, 0.0f, 1.0f);
    const float t1 = std::clamp((u + 0.5f - start) / length, 0.0f, 1.0f);
    return visibility_between(clipped_, sides_, segment, t0, t1, buffer_, options_);
}

Array<vec4> spine_table(const ClippedPaths& clipped, const OwnSides& sides) {
    check_sides(clipped, sides, "spine test");
    Array<vec4> table(3 * clipped.px.size(), vec4(0.0f));
    parallel_for(clipped.pieces.count(), 256, [&](std::size_t q) {
        for (Index i = clipped.pieces.begin(Index(q)); i + 1 < clipped.pieces.end(Index(q)); ++i)
            write_segment(clipped, sides, i, float(clipped.arc_px[i]), float(clipped.arc_px[i + 1]),
                          &table[3 * std::size_t(i)]);
    });
    return table;
}

}  // namespace fovea::visibility
