// SPDX-License-Identifier: GPL-3.0-or-later
// The principal frame of a symmetric form on a tangent plane.
#pragma once

#include <cmath>
#include <utility>

#include <fovea/field/curvature.h>
#include <fovea/mesh/height_jet.h>

namespace fovea {

/// Sets k and e of `c` from the shape operator [pp pq; pq qq] in the orthonormal frame (p, q), p x q the normal.
inline void set_principal(CurvatureD& c, const dvec3& p, const dvec3& q, double pp, double pq, double qq) {
    const double angle = 0.5 * std::atan2(2.0 * pq, pp - qq), cosine = std::cos(angle), sine = std::sin(angle);
    c.k1 = cosine * cosine * pp + 2 * cosine * sine * pq + sine * sine * qq;
    c.k2 = sine * sine * pp - 2 * cosine * sine * pq + cosine * cosine * qq;
    c.e1 = cosine * p + sine * q;
    c.e2 = cosine * q - sine * p;
    if (std::abs(c.k1) >= std::abs(c.k2)) return;
    std::swap(c.k1, c.k2);
    const dvec3 first = c.e1;
    c.e1 = c.e2;
    c.e2 = -first;
}

}  // namespace fovea
