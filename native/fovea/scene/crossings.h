// SPDX-License-Identifier: GPL-3.0-or-later
// Intersection curves of surfaces.
#pragma once

#include <fovea/scene/triangle_tree.h>

namespace fovea::scene {

/// Segment in which two triangles intersect. Each end is where a side of one triangle meets the other triangle; it has
/// a number, which the segment that continues beyond the side shares.
struct Crossing {
    Index triangle[2];  ///< of the first and of the second surface
    Index end[2];
    vec3 point[2];  ///< object space of the first surface
};

using Crossings = Array<Crossing>;

/// Distance below which surfaces count as touching, as a share of their size; comparable to the rounding of positions.
inline constexpr double contact_tolerance = 4e-7;

/// Intersection segments of two surfaces, the second mapped into the object space of the first. Signs are exact
/// (orientation.h) for vertices rounded to 2^-39 of the common size, so curves are closed where both surfaces are:
/// every end belongs to two segments, except at borders and where more than two triangles share a side. Vertices at the
/// same position count as one.
///
/// Surfaces that touch without crossing have no intersection, whichever way rounding moves them. Removed are: segments
/// between coplanar triangles; segments along a side at which a surface turns back, ends or continues in that plane (a
/// box on a floor: the lines there are its own creases); curves of negligible length; and crossings of surfaces that
/// stay beside each other (coincidence.h). The result depends on the arguments alone. `cancel` is polled.
Crossings cross(const Surface& first, const Surface& second, const Affine& second_to_first, const Cancel& cancel);

/// Self-intersections of a surface. Triangles that share an edge are not tested; those that share only a vertex are.
Crossings cross_itself(const Surface& surface, const Cancel& cancel);

}  // namespace fovea::scene
