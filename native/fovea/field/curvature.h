// SPDX-License-Identifier: GPL-3.0-or-later
// Curvature at a point of a surface: second fundamental form and its derivative, in the principal frame.
#pragma once

#include <fovea/base/types.h>

namespace fovea::field {

/// Second fundamental form h(x, y) = (D_x n) . y for the outward unit normal n: positive where convex, 1 / R on a
/// sphere of radius R. C is the covariant derivative of h, symmetric in all arguments. Units: k 1 / length, C 1 /
/// length^2. Rusinkiewicz, "Estimating Curvatures and Their Derivatives on Triangle Meshes", 3DPVT 2004. Negating the
/// frame (e1 -> -e1, e2 -> -e2) negates C and leaves k1 and k2. Where |k1| = |k2| the frame is arbitrary. Where no
/// surface surrounds the point all members are zero, including the normal. Without values unless it is given some, as
/// arrays of millions are filled in parallel.
template <typename Real>
struct CurvatureOf {
    using Vec3 = glm::vec<3, Real>;
    Vec3 normal;
    Vec3 e1, e2;  ///< principal directions, unit, e1 x e2 = normal
    Real k1, k2;  ///< principal curvatures along e1 and e2, |k1| >= |k2|
    Real C[4];    ///< C(e1,e1,e1), C(e1,e1,e2), C(e1,e2,e2), C(e2,e2,e2)
};

using Curvature = CurvatureOf<float>;    ///< as stored per vertex
using CurvatureD = CurvatureOf<double>;  ///< as computed

inline Curvature rounded(const CurvatureD& c) {
    return {vec3(c.normal), vec3(c.e1),  vec3(c.e2),
            float(c.k1),    float(c.k2), {float(c.C[0]), float(c.C[1]), float(c.C[2]), float(c.C[3])}};
}

}  // namespace fovea::field
