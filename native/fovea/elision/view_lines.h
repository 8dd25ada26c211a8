// SPDX-License-Identifier: GPL-3.0-or-later
// The lines of one frame that depend on its view, and on what of the scene they lie: for frames near it.
#pragma once

#include <algorithm>
#include <memory>
#include <vector>

#include <fovea/base/point_grid.h>
#include <fovea/path/paths.h>
#include <fovea/project/clipped_paths.h>
#include <fovea/scene/pose.h>

namespace fovea::elision {

/// The lines of a frame that depend on its view, as places a few pixels apart, without its scene, which frames share
/// and change.
struct ViewLines {
    struct Place {
        dvec2 px, way;        ///< in the image, and the unit vector along the line
        double arc;           ///< ClippedPaths::arc_px
        double arc_space;     ///< Paths::arc_obj
        double depth;         ///< distance along the view axis
        Index piece, placed;  ///< placed: index into those of `pose`
        SurfacePoint point;
        Kinds kinds;
    };

    Pose pose;  ///< of what has such lines
    Rows rows;  ///< per piece of ClippedPaths: its places in order; none of other lines
    Array<Place> places;
    Array<Index> path;                ///< per piece
    Array<std::uint8_t> closed;       ///< per piece
    std::unique_ptr<PointGrid> grid;  ///< of the places

    std::size_t bytes() const;  ///< about
    /// Which place of a piece is at an arc length, from 0, between places by shares; beyond its ends these.
    double number_at(Index piece, double arc) const;
};

/// How much value(place) changes per pixel of arc length at a place, over its neighbors.
template <typename Value>
double slope_at(const ViewLines& lines, Index place, const Value& value) {
    const Index piece = lines.places[place].piece;
    const Index before = std::max(place, lines.rows.begin(piece) + 1) - 1;
    const Index after = std::min(place + 1, lines.rows.end(piece) - 1);
    return (value(after) - value(before)) / (lines.places[after].arc - lines.places[before].arc);
}

/// Lines that are found in the image, and those that make a tone, have no places.
ViewLines view_lines(const ClippedPaths& clipped, const Paths& paths, const Scene& scene, const View& view);

/// Values per atlas sample at the places; 1 where there are no samples.
Array<float> values_at_places(const ViewLines& lines, const ClippedPaths& clipped, In<float> values);

/// Sets values per atlas sample from those of the places. `where`: per atlas sample, whether it does.
void values_from_places(Array<float>& values, const ViewLines& lines, const ClippedPaths& clipped,
                        In<std::uint8_t> where, In<float> at_places);

}  // namespace fovea::elision
