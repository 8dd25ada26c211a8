// SPDX-License-Identifier: GPL-3.0-or-later
// Exact orientation predicate with symbolic perturbation.
#pragma once

#include <fovea/base/types.h>

namespace fovea::scene {

/// Bound of the coordinates, which must be integers, of the points of orientation().
inline constexpr double grid_limit = 549755813888.0;  // 2^39: a determinant then fits 128 bits

/// Relative error of such a determinant in doubles, from exact differences of points: of the sum of the magnitudes of
/// its products. Shewchuk, "Adaptive Precision Floating-Point Arithmetic and Fast Robust Geometric Predicates", 1997:
/// (7 + 56 u) u with u = 2^-53.
inline constexpr double orientation_error = 7.8e-16;

struct Orientation {
    /// Six times the signed volume of the tetrahedron, rounded to double; exactly 0 if the points are coplanar.
    double value;
    int sign;  ///< sign of `value`, or if that is 0, of the volume after symbolic perturbation
};

/// Orientation of four grid points: positive if the fourth lies below the plane of the first three, which appear
/// counterclockwise from above. Coplanar points are resolved by symbolic perturbation:
/// - Points of two surfaces (bit i of `second` is set if p[i] belongs to the second one): the second surface is
///   translated by (e, e^2, e^3) for an infinitesimal e. The sign is 0 only if a triangle or edge is degenerate.
/// - Points of one surface (`second` is 0, or all bits): every point is perturbed individually; Edelsbrunner & Mücke,
///   "Simulation of Simplicity", TOG 1990. The sign is 0 only if two of the points coincide.
Orientation orientation(const dvec3 (&p)[4], unsigned second);

/// Lexicographic order (x, then y, then z) of grid points, which ranks their perturbations.
inline bool before(const dvec3& a, const dvec3& b) {
    return a.x != b.x ? a.x < b.x : a.y != b.y ? a.y < b.y : a.z < b.z;
}

}  // namespace fovea::scene
