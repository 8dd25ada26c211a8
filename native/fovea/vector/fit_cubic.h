// SPDX-License-Identifier: GPL-3.0-or-later
// One cubic Bezier through the ends of a polyline, nearest to it in the least squares sense. Schneider, "An Algorithm
// for Automatically Fitting Digitized Curves", Graphics Gems, 1990, with three differences: ends without a given
// tangent are free, points count by the length that they stand for, and the bound holds for all of both lines, not for
// points at equal parameters alone.
#pragma once

#include <optional>

#include <fovea/vector/curve.h>

namespace fovea::vector {

/// Unit vectors along the way of a polyline at its ends; unset: free.
struct Tangents {
    std::optional<dvec2> start, end;
};

/// A cubic from the first to the last of at least two points, no two neighbors of which coincide. None if there is none
/// within `tolerance`: every point of the polyline is that near to the cubic, and every point of the cubic that near to
/// the polyline.
std::optional<Cubic> fit_cubic(In<dvec2> points, const Tangents& tangents, double tolerance);

/// Distance of a point from a line segment.
double distance_to_segment(const dvec2& point, const dvec2& a, const dvec2& b);

}  // namespace fovea::vector
