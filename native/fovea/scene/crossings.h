// SPDX-License-Identifier: GPL-3.0-or-later
// Where surfaces pass through each other.
#pragma once

#include <fovea/scene/triangle_tree.h>

namespace fovea::scene {

/// The straight piece in which two triangles cross. An end is where a side of one meets the other triangle; it has a
/// number, by which the piece of the next triangle beyond the side goes on from it.
struct Crossing {
    Index triangle[2];  ///< of the first and of the second surface
    Index end[2];
    vec3 point[2];  ///< object space of the first surface
};

using Crossings = Array<Crossing>;

/// What is nearer than this share of the size of two surfaces (as large as rounding of positions is) touches.
inline constexpr double contact_tolerance = 4e-7;

/// Crossings of two surfaces, the second mapped into the object space of the first. Signs are exact (orientation.h) for
/// vertices rounded to 2^-39 of the size of both, so that curves are closed where both surfaces are: every end has two
/// pieces but at borders and where more than two triangles meet at a side. Vertices in the same place are the same.
///
/// Surfaces that touch without passing through each other do not cross, whichever side of one another rounding puts
/// them on: left out are pieces between triangles that lie in one plane; along a side at which the surface turns back
/// or ends or goes on in that plane (a box on a floor, whose lines there are its own creases); and curves of no length.
/// The result depends on the arguments alone.
Crossings cross(const Surface& first, const Surface& second, const Affine& second_to_first, const Cancel& cancel);

/// Crossings of triangles of one surface; triangles that share an edge do not cross, and those that share a vertex may.
Crossings cross_itself(const Surface& surface, const Cancel& cancel);

}  // namespace fovea::scene
