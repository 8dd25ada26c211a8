// SPDX-License-Identifier: GPL-3.0-or-later
// On which side of a plane a point lies: exact, and never undecided where surfaces touch.
#pragma once

#include <fovea/base/types.h>

namespace fovea::scene {

/// Points whose orientation is asked have whole coordinates of at most this size.
inline constexpr double grid_limit = 549755813888.0;  // 2^39: a determinant then fits 128 bits

struct Orientation {
    double value;  ///< six times the signed volume of the tetrahedron; exactly 0 where the points are coplanar
    int sign;      ///< of `value`, or where that is 0 of the points after symbolic perturbation
};

/// Orientation of four grid points, positive where the fourth lies below the plane of the first three, which seen from
/// above run counterclockwise. Coplanar points are told apart by symbolic perturbation:
/// - Points of two surfaces (bit i of `second` is set where p[i] belongs to the second one): that one is shifted as a
///   whole, by (e, e^2, e^3) for an infinitesimal e. The sign is 0 only where a triangle or an edge has no extent.
/// - Points of one surface (`second` 0, or all): every point moves on its own; Edelsbrunner & Mücke, "Simulation of
///   Simplicity", TOG 1990. The sign is 0 only where two of the points are the same.
Orientation orientation(const dvec3 (&p)[4], unsigned second);

/// Order of grid points in which perturbations are ranked: by x, then y, then z.
inline bool before(const dvec3& a, const dvec3& b) {
    return a.x != b.x ? a.x < b.x : a.y != b.y ? a.y < b.y : a.z < b.z;
}

}  // namespace fovea::scene
