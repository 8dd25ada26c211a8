// SPDX-License-Identifier: GPL-3.0-or-later
// Output of projection and clipping: pieces of paths in pixels, with their samples in the segment atlas.
#pragma once

#include <algorithm>

#include <fovea/base/columns.h>
#include <fovea/base/view.h>

namespace fovea::project {

/// Depth of lines that nothing occludes: in front of any surface, whatever its slope.
inline constexpr float before_all = 1e30f;

/// How a piece begins and ends: at an end of its path, at the seam of a closed path, or, with no bit set, clipped by
/// the frame.
enum PieceEnds : std::uint8_t { path_start = 1, path_end = 2, seam_start = 4, seam_end = 8 };

/// Paths projected and clipped to the frame. A piece is what one path leaves inside the frame (a path that leaves
/// and comes back gives several), a polyline of points; segment i runs from point i to point i + 1 of a piece.
/// The last point of every piece starts no segment: its sample_count is 0.
struct ClippedPaths {
    /// Pieces: points pieces.begin(q) .. pieces.end(q).
    Rows pieces;
    Array<Index> path;
    Array<std::uint8_t> closed, free_ends, ends;
    Array<double> path_length_px;
    Array<vec2> px;
    Array<float> depth;
    Array<vec3> position_view;
    Array<double> arc_px;
    Array<Index> source;
    Array<float> source_t;
    Array<Index> facet0, facet1;
    Array<Index> sample_start, sample_count;

    static constexpr auto piece_columns = each_of(
        Column{"path", &ClippedPaths::path, "(Q,) uint32 path it comes from"},
        Column{"closed", &ClippedPaths::closed,
               "(Q,) uint8: 1 where a whole closed path lies inside the frame (first and last point coincide)"},
        Column{"free_ends", &ClippedPaths::free_ends,
               "(Q,) uint8: 1 where it starts, 2 where it ends with an end of the path that touches no other line: "
               "there pens taper"},
        Column{"path_length_px", &ClippedPaths::path_length_px,
               "(Q,) float64 pixels of its whole path, whatever of it is outside of the frame or hidden; what lies "
               "behind the near plane, or a million frames away, has no pixels and does not count"},
        Column{"ends", &ClippedPaths::ends,
               "(Q,) uint8: 1 starts, 2 ends with its path's end; 4 starts, 8 ends at a closed path's seam; else the "
               "frame cuts it"});
    static constexpr auto point_columns = each_of(
        Column{"px", &ClippedPaths::px, "(M, 2) float32 pixels"},
        Column{"depth", &ClippedPaths::depth,
               "(M,) float32, reversed and screen-linear (base/view.h); before_all where nothing hides the path"},
        Column{"position_view", &ClippedPaths::position_view, "(M, 3) float32 view space"},
        Column{"arc_px", &ClippedPaths::arc_px,
               "(M,) float64 arc length in pixels along the whole path, 0 at its middle, independent of clipping"},
        Column{"source", &ClippedPaths::source, "(M,) uint32 point of Paths"},
        Column{"source_t", &ClippedPaths::source_t, "(M,) float32 fraction towards the next point"},
        Column{"facet0", &ClippedPaths::facet0,
               "(M,) uint32: with facet1 the facets at the mesh edge of the segment from this point, numbered over the "
               "whole scene, which visibility ignores; 0xffffffff: none"},
        Column{"facet1", &ClippedPaths::facet1, "(M,) uint32: see facet0"},
        Column{
            "sample_start", &ClippedPaths::sample_start,
            "(M,) uint32: the segment from this point has the samples sample_start .. sample_start + sample_count of "
            "the atlas; sample j lies at its screen fraction (j + 0.5) / sample_count"},
        Column{"sample_count", &ClippedPaths::sample_count, "(M,) uint32, 0 at the end of a piece"});

    /// Number of samples in the atlas.
    Index samples = 0;
    /// Orthographic view: fractions of a segment on the screen equal those in space.
    bool orthographic = false;

    /// Arc length at which a piece begins, and at which it ends.
    double first_arc(Index piece) const { return arc_px[pieces.begin(piece)]; }
    double last_arc(Index piece) const { return arc_px[pieces.end(piece) - 1]; }
    /// The segment of a piece at an arc length, by its first point; beyond its ends the first or the last.
    Index segment_at(Index piece, double arc) const {
        const auto inner = arc_px.begin() + pieces.begin(piece) + 1, last = arc_px.begin() + pieces.end(piece) - 1;
        return Index(std::upper_bound(inner, last, arc) - arc_px.begin()) - 1;
    }
    /// Fraction of a segment before an arc length, in [0, 1]; `otherwise` if the segment has no length.
    double share_at(Index segment, double arc, double otherwise = 0.0) const {
        const double length = arc_px[segment + 1] - arc_px[segment];
        return length > 0.0 ? std::clamp((arc - arc_px[segment]) / length, 0.0, 1.0) : otherwise;
    }
    /// Index of a piece's first atlas sample. Samples of pieces are contiguous: those of a piece end where the next
    /// piece's begin.
    Index first_sample(Index piece) const {
        return piece < pieces.count() ? sample_start[pieces.begin(piece)] : samples;
    }
    /// Pixel position at an arc length of a piece, clamped to its ends.
    vec2 place_px(Index piece, double arc) const {
        const Index i = segment_at(piece, arc);
        return glm::mix(px[i], px[i + 1], float(share_at(i, arc)));
    }
    /// Share of a segment's way in space at a share of its way in the image.
    double in_space(Index segment, double share) const {
        if (orthographic) return share;
        return share_in_space(share, -double(position_view[segment].z), -double(position_view[segment + 1].z));
    }
    /// View-space position there.
    dvec3 position_at(Index segment, double share) const {
        return glm::mix(dvec3(position_view[segment]), dvec3(position_view[segment + 1]), in_space(segment, share));
    }
    /// Per-point values of Paths, interpolated at a clipped point.
    float at_point(In<float> values, Index point) const { return between_points(values, point); }
    vec3 at_point(In<vec3> values, Index point) const { return between_points(values, point); }

   private:
    template <typename T>
    T between_points(In<T> values, Index point) const {
        const T here = values[source[point]];
        const float t = source_t[point];
        // The last point of a path has no next point.
        return t > 0.0f ? glm::mix(here, values[source[point] + 1], t) : here;
    }
};

}  // namespace fovea::project
