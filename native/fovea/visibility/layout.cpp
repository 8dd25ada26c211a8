// SPDX-License-Identifier: GPL-3.0-or-later
#include <fovea/visibility/layout.h>

#include <fovea/base/check.h>

namespace fovea {
namespace {

/// Points of the batch's pieces that start a segment with samples.
Array<Index> segments_of(const ClippedPaths& clipped, const AtlasBatch& batch) {
    Array<Index> points;
    for (Index i = clipped.pieces.offsets[batch.piece_begin]; i < clipped.pieces.offsets[batch.piece_end]; ++i)
        if (clipped.sample_count[i] > 0) points.push_back(i);
    return points;
}

}  // namespace

Rows piece_samples(const ClippedPaths& clipped) {
    const Index pieces = clipped.pieces.count();
    Rows rows;
    rows.offsets.resize(pieces + 1);
    for (Index q = 0; q < pieces; ++q) rows.offsets[q] = clipped.sample_start[clipped.pieces.begin(q)];
    rows.offsets[pieces] = clipped.samples;
    return rows;
}

Array<AtlasBatch> atlas_batches(const ClippedPaths& clipped, Index limit) {
    const Rows samples = piece_samples(clipped);
    Array<AtlasBatch> batches;
    for (Index q = 0; q < samples.count();) {
        Index end = q + 1;
        while (end < samples.count() && samples.end(end) - samples.begin(q) <= limit) ++end;
        if (samples.end(end - 1) > samples.begin(q))
            batches.push_back({q, end, samples.begin(q), samples.end(end - 1)});
        q = end;
    }
    return batches;
}

AtlasTables atlas_tables(const ClippedPaths& clipped, const OwnSides& sides, const AtlasBatch& batch) {
    check(sides.inner.size() == clipped.px.size() && sides.steepness.size() == clipped.px.size() &&
              batch.piece_end <= clipped.pieces.count() && batch.sample_end <= clipped.samples,
          "segment atlas: a batch or own sides of other paths");
    const Array<Index> points = segments_of(clipped, batch);
    const Index segments = static_cast<Index>(points.size());
    AtlasTables tables;
    tables.segments.resize(3 * std::size_t(segments));
    for (Index s = 0; s < segments; ++s) {
        const Index i = points[s];
        vec4* row = &tables.segments[3 * std::size_t(s)];
        row[0] = {clipped.px[i], clipped.depth[i], float(clipped.sample_start[i] - batch.sample_begin)};
        row[1] = {clipped.px[i + 1], clipped.depth[i + 1], float(clipped.sample_count[i])};
        row[2] = {facet_number(clipped.facet0[i]), facet_number(clipped.facet1[i]),
                  sides.inner[i] ? -1.0f : sides.steepness[i], 0.0f};
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

}  // namespace fovea
