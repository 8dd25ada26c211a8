// What projection and clipping hand on: pieces of paths in pixels, each with its share of the segment atlas.
#pragma once

#include "base/types.h"

namespace fovea {

/// The depth of lines that nothing hides: nearer than any surface, however steep it is.
inline constexpr float before_all = 1e30f;

/// How a piece begins and ends: with an end of its path, at the seam of a closed path, or, with no bit set, cut by the
/// frame.
enum PieceEnds : std::uint8_t { path_start = 1, path_end = 2, seam_start = 4, seam_end = 8 };

/// Paths projected and clipped to the frame. A piece is what one path leaves inside the frame (a path that leaves
/// and comes back gives several), a polyline of points; segment i runs from point i to point i + 1 of a piece.
/// The last point of every piece starts no segment: its sample_count is 0.
struct ClippedPaths {
    /// Pieces: points pieces.begin(q) .. pieces.end(q).
    Rows pieces;
    /// Per piece: index of the path it comes from.
    Array<Index> path;
    /// Per piece: 1 where a whole closed path lies inside the frame (first and last point coincide).
    Array<std::uint8_t> closed;
    /// Per piece: 1 where it starts, 2 where it ends with an end of the path that touches no other line: there pens taper.
    Array<std::uint8_t> free_ends;
    /// Per piece: pixels of its whole path, whatever of it is outside of the frame or hidden; only what lies behind the
    /// near plane, which has no pixels, does not count.
    Array<double> path_length_px;
    /// Per piece: PieceEnds bits.
    Array<std::uint8_t> ends;
    /// Per point: pixels (screen), reversed screen-linear depth (base/view.h; before_all where nothing hides the
    /// path), view space.
    Array<vec2> px;
    Array<float> depth;
    Array<vec3> position_view;
    /// Per point: arc length in pixels along the whole path, 0 at the path's middle, independent of clipping.
    Array<double> arc_px;
    /// Per point: where on the path it is: point index in Paths, and the fraction towards the next one.
    Array<Index> source;
    Array<float> source_t;
    /// Per segment (indexed by its first point): the two facets at its mesh edge, numbered over the whole scene;
    /// `none` where there are fewer. Visibility ignores them.
    Array<Index> facet0, facet1;
    /// Per segment: its samples are sample_start .. sample_start + sample_count of the atlas; sample j lies at the
    /// screen fraction (j + 0.5) / sample_count of the segment.
    Array<Index> sample_start, sample_count;
    /// Samples in the atlas.
    Index samples = 0;
    /// Whether screen fractions of a segment are also fractions of it in space.
    bool orthographic = false;
};

}  // namespace fovea
