// SPDX-License-Identifier: GPL-3.0-or-later
// Layout of the segment atlas: the segment that owns each sample, and batches that fit into textures.
#pragma once

#include <fovea/project/clipped_paths.h>
#include <fovea/visibility/own_sides.h>

namespace fovea::visibility {

/// The atlas is one row of samples wrapped over texture rows of this width.
inline constexpr Index atlas_width = 2048;
/// Maximum number of samples per batch; a longer piece is a batch of its own.
inline constexpr Index batch_samples = Index(1) << 22;
/// Stride [samples] of the table of owner segments.
inline constexpr Index owner_stride = 64;
/// Facet numbers are stored modulo this, so that float textures hold them exactly; -1: none.
inline constexpr Index facet_modulus = Index(1) << 24;
inline float facet_number(Index facet) { return facet == none ? -1.0f : float(facet % facet_modulus); }

/// Whole pieces whose samples fit into one atlas texture.
struct AtlasBatch {
    Index piece_begin = 0, piece_end = 0;
    Index sample_begin = 0, sample_end = 0;  ///< samples of the whole atlas; inside the batch they count from 0
};

/// Consecutive batches of at most `limit` samples (or one piece).
Array<AtlasBatch> atlas_batches(const ClippedPaths& clipped, Index limit = batch_samples);

/// Writes the three table entries of the segment from point i. `with_start` and `with_end` are the last components of
/// the entries of its start and its end, whose meaning differs between passes.
void write_segment(const ClippedPaths& clipped, const OwnSides& sides, Index i, float with_start, float with_end,
                   vec4* rows);

/// Input tables of the visibility pass: three entries per segment that has samples, in atlas order:
/// (x0, y0, depth0, first sample), (x1, y1, depth1, sample count),
/// (facet0, facet1, steepness, or -1 for an inner line, 0). Sample numbers are relative to the batch.
struct AtlasTables {
    Array<vec4> segments;
    /// Segment that owns sample 0, owner_stride, 2 owner_stride, ... of the batch; one more entry closes the table
    /// with the last segment.
    Array<float> owners;
};

/// Throws std::invalid_argument where batch or sides belong to other paths.
AtlasTables atlas_tables(const ClippedPaths& clipped, const OwnSides& sides, const AtlasBatch& batch);

}  // namespace fovea::visibility
