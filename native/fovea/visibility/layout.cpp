// SPDX-License-Identifier: GPL-3.0-or-later
#include <fovea/visibility/layout.h>

#include <fovea/base/check.h>

namespace fovea::visibility {
namespace {

/// Points of the batch's pieces that start a segment with samples.
Array<Index> segments_of(const ClippedPaths& clipped, const AtlasBatch& batch) {
    Array<Index> points;
    for (Index i = clipped.pieces.offsets[batch.piece_begin]; i < clipped.pieces.offsets[batch.piece_end]; ++i)
        if (clipped.sample_count[i] > 0) points.push_back(i);
    return points;
}

}  // namespace

Array<AtlasBatch> atlas_batches(const ClippedPaths& clipped, Index limit) {
    Array<AtlasBatch> batches;
    for (Index q = 0; q < clipped.pieces.count();) {
        const Index first = clipped.first_sample(q);
        Index end = q + 1;
        while (end < clipped.pieces.count() && clipped.first_sample(end + 1) - first <= limit) ++end;
        if (clipped.first_sample(end) > first) batches.push_back({q, end, first, clipped.first_sample(end)});
        q = end;
    }
    return batches;
}

void write_segment(const ClippedPaths& clipped, const OwnSides& sides, Index i, float with_start, float with_end,
                   vec4* rows) {
    rows[0] = {clipped.px[i], clipped.depth[i], with_start};
    rows[1] = {clipped.px[i + 1], clipped.depth[i + 1], with_end};
    rows[2] = {facet_number(clipped.facet0[i]), facet_number(clipped.facet1[i]), sides.in_tables(i), 0.0f};
}

AtlasTables atlas_tables(const ClippedPaths& clipped, const OwnSides& sides, const AtlasBatch& batch) {
    check_sides(clipped, sides, "segment atlas");
    check(batch.piece_end <= clipped.pieces.count() && batch.sample_end <= clipped.samples,
          "segment atlas: a batch or own sides of other paths");
    const Array<Index> points = segments_of(clipped, batch);
    const Index segments = static_cast<Index>(points.size());
    AtlasTables tables;
    tables.segments.resize(3 * std::size_t(segments));
    for (Index s = 0; s < segments; ++s) {
        const Index i = points[s];
        write_segment(clipped, sides, i, float(clipped.sample_start[i] - batch.sample_begin),
                      float(clipped.sample_count[i]), &tables.segments[3 * std::size_t(s)]);
    }
    if (segments == 0) return tables;
    Index owner = 0;
    for (Index sample = batch.sample_begin; sample < batch.sample_end; sample += owner_stride) {
        while (owner + 1 < segments && clipped.sample_start[points[owner + 1]] <= sample) ++owner;
        tables.owners.push_back(float(owner));
    }
    tables.owners.push_back(float(segments - 1));
    return tables;
}

}  // namespace fovea::visibility
