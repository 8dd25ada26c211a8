// SPDX-License-Identifier: GPL-3.0-or-later
// Directions in which a surface bends most, smooth over the surface and everywhere defined: what hatching follows.
#pragma once

#include <array>
#include <memory>

#include <fovea/mesh/surface.h>

namespace fovea::field {

/// Per corner of each triangle: the unit direction of the greatest signed curvature (convex is positive), in the
/// tangent plane, up to its sign: around a limb, not along it. Found from the bends at the sides of triangles
/// (Cohen-Steiner & Morvan, "Restricted Delaunay Triangulations and Normal Cycle", SoCG 2003), averaged over a
/// part of the surface, the same however fine the mesh is, up to sides at which it is folded by more than 40 degrees.
/// Where it bends alike in all directions, as on planes and spheres: at right angles to the Z axis, along X where that
/// is the normal. On degenerate triangles zero.
struct BendDirections {
    Array<std::array<vec3, 3>> corner;
    bool any = false;  ///< whether it bends more in one direction than in others anywhere
};

/// Those of the rest shape, if the surface has one, in its space: so they stay where they are while it deforms. Cached
/// with the surface.
std::shared_ptr<const BendDirections> bend_directions(const Surface& surface);

/// Whether a surface goes on smoothly from one triangle to the other across the side that they share, at points
/// `positions`: they are wound alike, and folded by at most 40 degrees.
bool goes_on(In<vec3> positions, const Triangle& one, const Triangle& other);

}  // namespace fovea::field
