// SPDX-License-Identifier: GPL-3.0-or-later
// Tangent frames: the principal frame of a symmetric form, and parallel transport between tangent planes.
#pragma once

#include <cmath>
#include <utility>

#include <fovea/base/elementary.h>
#include <fovea/field/curvature.h>
#include <fovea/mesh/height_jet.h>

namespace fovea::field {

/// Sets k1, k2, e1, e2 of `c` from the shape operator [pp pq; pq qq] in the orthonormal frame (p, q), p x q = normal.
inline void set_principal(CurvatureD& c, const dvec3& p, const dvec3& q, double pp, double pq, double qq) {
    const double angle = 0.5 * angle_of(2.0 * pq, pp - qq), along = cosine(angle), across = sine(angle);
    c.k1 = along * along * pp + 2 * along * across * pq + across * across * qq;
    c.k2 = across * across * pp - 2 * along * across * pq + along * along * qq;
    c.e1 = along * p + across * q;
    c.e2 = along * q - across * p;
    if (std::abs(c.k1) >= std::abs(c.k2)) return;
    std::swap(c.k1, c.k2);
    const dvec3 first = c.e1;
    c.e1 = c.e2;
    c.e2 = -first;
}

/// Components along t and b of the tangent directions (p, q), rotated from the plane with normal `from` to that
/// of (t, b) by the smallest rotation.
struct Turn {
    double pt, pb, qt, qb;
    Turn(const dvec3& p, const dvec3& q, const dvec3& from, const dvec3& t, const dvec3& b) {
        const dvec3 to = glm::cross(t, b);
        const double cosine = glm::dot(from, to);
        if (cosine <= -1.0 + 1e-12) {
            pt = -glm::dot(p, t), pb = -glm::dot(p, b), qt = -glm::dot(q, t), qb = -glm::dot(q, b);
            return;
        }
        const dvec3 mean = (from + to) / (1.0 + cosine), across = to - cosine * from;
        const dvec3 p1 = p - mean * glm::dot(p, across), q1 = q - mean * glm::dot(q, across);
        pt = glm::dot(p1, t), pb = glm::dot(p1, b), qt = glm::dot(q1, t), qb = glm::dot(q1, b);
    }
};

/// h(t, t), h(t, b), h(b, b) of a point whose frame (e1, e2) was transported by `turn`.
inline dvec3 turned_form(const Curvature& c, const Turn& turn) {
    return {c.k1 * turn.pt * turn.pt + c.k2 * turn.qt * turn.qt, c.k1 * turn.pt * turn.pb + c.k2 * turn.qt * turn.qb,
            c.k1 * turn.pb * turn.pb + c.k2 * turn.qb * turn.qb};
}

}  // namespace fovea::field
