// SPDX-License-Identifier: GPL-3.0-or-later
// What a viewer sees of curvature at a point. Views of points are exact functions of the point's curvature.
#pragma once

#include <algorithm>
#include <cmath>

#include <fovea/field/curvature.h>

namespace fovea::field {

/// A point as it is seen: the direction towards the viewer in the frame (e1, e2, normal).
template <typename Real>
struct SeenOf {
    Real u, w;              ///< along e1 and e2
    Real facing;            ///< along the normal: n . v
    Real inverse_distance;  ///< of the viewer; 0 for an orthographic view
    /// Squared sine of the angle between normal and view.
    Real sine2() const { return u * u + w * w; }
};

/// `towards`: unit, from the point to the viewer.
template <typename Real>
SeenOf<Real> see(const CurvatureOf<Real>& c, const glm::vec<3, Real>& towards, Real inverse_distance) {
    return {glm::dot(towards, c.e1), glm::dot(towards, c.e2), glm::dot(towards, c.normal), inverse_distance};
}

/// C(x, x, x) for a tangent (x, y) in the principal frame.
template <typename Real>
Real third_form(const CurvatureOf<Real>& c, Real x, Real y) {
    return ((c.C[0] * x + 3 * c.C[1] * y) * x + 3 * c.C[2] * y * y) * x + c.C[3] * y * y * y;
}

/// Curvature along the view direction projected onto the surface, W. DeCarlo et al., "Suggestive Contours for Conveying
/// Shape", SIGGRAPH 2003; DeCarlo, Finkelstein & Rusinkiewicz, "Interactive Rendering of Suggestive Contours with
/// Temporal Coherence", NPAR 2004. Seen head-on (sine 0), W is nowhere: torsion and derivative are 0.
template <typename Real>
struct RadialOf {
    Real scaled;      ///< radial curvature times the squared sine; its zeros are those of the radial curvature
    Real curvature;   ///< k_r = h(W, W)
    Real torsion;     ///< h(W, W turned by 90 degrees)
    Real derivative;  ///< sine times the derivative of k_r along W; finite everywhere
};

template <typename Real>
Real radial_scaled(const CurvatureOf<Real>& c, const SeenOf<Real>& seen) {
    return c.k1 * (seen.u * seen.u) + c.k2 * (seen.w * seen.w);
}

template <typename Real>
RadialOf<Real> radial(const CurvatureOf<Real>& c, const SeenOf<Real>& seen) {
    const Real s2 = seen.sine2();
    RadialOf<Real> r{radial_scaled(c, seen), 0, 0, 0};
    if (s2 < Real(1e-12)) return r;
    r.curvature = r.scaled / s2;
    r.torsion = (c.k2 - c.k1) * seen.u * seen.w / s2;
    r.derivative = third_form(c, seen.u, seen.w) / s2 - 2 * seen.facing * r.torsion * r.torsion;
    return r;
}

/// Curvature as it appears in the image, and how it changes along the direction of its greatest value. Judd, Durand &
/// Adelson, "Apparent Ridges for Line Drawing", SIGGRAPH 2007; the derivative in closed form instead of differences.
template <typename Real>
struct ViewCurvatureOf {
    Real squared;  ///< square of the greatest view-dependent curvature
    Real a1, a2;   ///< tangent (in e1, e2) whose image is the unit direction of that curvature; its sign is arbitrary
    Real derivative;  ///< of `squared` along (a1, a2); turns around with them
};

/// n . v is kept from 0 by `least_facing`: the curvature of contours is infinite.
template <typename Real>
ViewCurvatureOf<Real> view_curvature(const CurvatureOf<Real>& c, const SeenOf<Real>& seen,
                                     Real least_facing = Real(1e-3)) {
    // Inverse projection I + (1 / |n.v| - 1) W W^T; Q = S P^-1; the eigenvector of Q^T Q with the greater eigenvalue.
    const Real facing = std::max(std::abs(seen.facing), least_facing), s2 = seen.sine2();
    const Real stretch = s2 > Real(1e-12) ? (1 / facing - 1) / s2 : Real(0);
    const Real p11 = 1 + stretch * seen.u * seen.u, p12 = stretch * seen.u * seen.w,
               p22 = 1 + stretch * seen.w * seen.w;
    const Real q11 = c.k1 * p11, q12 = c.k1 * p12, q21 = c.k2 * p12, q22 = c.k2 * p22;
    const Real m11 = q11 * q11 + q21 * q21, m12 = q11 * q12 + q21 * q22, m22 = q12 * q12 + q22 * q22;
    const Real half = Real(0.5) * (m11 - m22), root = std::sqrt(half * half + m12 * m12);
    ViewCurvatureOf<Real> v;
    v.squared = Real(0.5) * (m11 + m22) + root;
    Real t1 = half >= 0 ? half + root : m12, t2 = half >= 0 ? m12 : root - half;
    const Real length = std::sqrt(t1 * t1 + t2 * t2);
    if (length > 0) {
        t1 /= length;
        t2 /= length;
    } else {  // the same in all directions
        t1 = 1;
        t2 = 0;
    }
    v.a1 = p11 * t1 + p12 * t2;
    v.a2 = p12 * t1 + p22 * t2;
    const Real a11 = v.a1 * v.a1, a12 = v.a1 * v.a2, a22 = v.a2 * v.a2;
    const Real third = (a11 * c.C[0] + 2 * a12 * c.C[1] + a22 * c.C[2]) * c.k1 * v.a1 +
                       (a11 * c.C[1] + 2 * a12 * c.C[2] + a22 * c.C[3]) * c.k2 * v.a2;
    const Real towards = seen.u * v.a1 + seen.w * v.a2, along = c.k1 * a11 + c.k2 * a22;
    v.derivative = 2 * (third - v.squared * towards * (seen.inverse_distance + seen.facing * along));
    return v;
}

/// Laplacian of n . v over the surface, v held: zero on Laplacian lines. Zhang et al., "Real-time Feature-based Line
/// Drawing with Laplacian lines", TVCG 2009, through the curvature tensor's derivative instead of a mesh Laplacian.
template <typename Real>
Real laplacian(const CurvatureOf<Real>& c, const SeenOf<Real>& seen) {
    return seen.u * (c.C[0] + c.C[2]) + seen.w * (c.C[1] + c.C[3]) - (c.k1 * c.k1 + c.k2 * c.k2) * seen.facing;
}

/// Squared length of the gradient of n . v on the surface.
template <typename Real>
Real gradient2(const CurvatureOf<Real>& c, const SeenOf<Real>& seen) {
    const Real x = c.k1 * seen.u, y = c.k2 * seen.w;
    return x * x + y * y;
}

/// The direction in which curvature changes most. Kolomenkin, Shimshoni & Tal, "Demarcating Curves for Shape
/// Illustration", SIGGRAPH Asia 2008.
template <typename Real>
struct DemarcatingOf {
    Real g1, g2;     ///< unit tangent (in e1, e2) with the greatest C(g, g, g)
    Real curvature;  ///< h(g, g): zero on demarcating curves
    Real strength;   ///< C(g, g, g), not negative
};

/// C(g, g, g) over the angle t of g = (cos t, sin t): A cos(t - alpha) + B cos(3 t - beta).
template <typename Real>
class ThirdFormByAngle {
   public:
    explicit ThirdFormByAngle(const CurvatureOf<Real>& c)
        : a(Real(0.75) * (c.C[0] + c.C[2])),
          b(Real(0.75) * (c.C[1] + c.C[3])),
          p(Real(0.25) * (c.C[0] - 3 * c.C[2])),
          q(Real(0.25) * (3 * c.C[1] - c.C[3])) {}
    Real operator()(Real t) const {
        return a * std::cos(t) + b * std::sin(t) + p * std::cos(3 * t) + q * std::sin(3 * t);
    }
    /// A maximum, by Newton's steps that climb, from t.
    Real climb(Real t) const {
        for (int step = 0; step < 20; ++step) {
            const Real slope = -a * std::sin(t) + b * std::cos(t) - 3 * p * std::sin(3 * t) + 3 * q * std::cos(3 * t);
            const Real bend = -a * std::cos(t) - b * std::sin(t) - 9 * p * std::cos(3 * t) - 9 * q * std::sin(3 * t);
            const Real limit = Real(0.2);
            const Real move = bend < 0 ? std::clamp(-slope / bend, -limit, limit) : slope > 0 ? limit : -limit;
            if (!(std::abs(move) > Real(1e-12))) break;
            t += move;
        }
        return t;
    }
    const Real a, b, p, q;
};

template <typename Real>
DemarcatingOf<Real> demarcating_at(const CurvatureOf<Real>& c, Real angle, Real strength) {
    DemarcatingOf<Real> d{std::cos(angle), std::sin(angle), 0, strength};
    d.curvature = c.k1 * d.g1 * d.g1 + c.k2 * d.g2 * d.g2;
    return d;
}

/// The same for a maximum of C(g, g, g) near a tangent (x, y), though another be greater.
template <typename Real>
DemarcatingOf<Real> demarcating_near(const CurvatureOf<Real>& c, Real x, Real y) {
    const ThirdFormByAngle<Real> third(c);
    const Real t = third.climb(std::atan2(y, x));
    return demarcating_at(c, t, third(t));
}

template <typename Real>
DemarcatingOf<Real> demarcating(const CurvatureOf<Real>& c) {
    // The greatest value lies within 60 degrees of one of the three maxima of the second term.
    const ThirdFormByAngle<Real> value(c);
    constexpr Real third = Real(2.0943951023931953);
    const Real first = std::atan2(value.q, value.p) / 3, mean = std::atan2(value.b, value.a);
    const Real starts[4] = {first, first + third, first - third, mean};
    Real best = 0, most = value(0);
    for (const Real start : starts) {
        const Real t = value.climb(start);
        if (value(t) > most) {
            most = value(t);
            best = t;
        }
    }
    return demarcating_at(c, best, most);
}

}  // namespace fovea::field
