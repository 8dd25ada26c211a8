// SPDX-License-Identifier: GPL-3.0-or-later
// View-dependent curvature quantities at a point, in closed form from its curvature.
#pragma once

#include <algorithm>
#include <cmath>
#include <utility>

#include <fovea/base/elementary.h>
#include <fovea/field/curvature.h>

namespace fovea::field {

/// The unit direction from a point to the viewer, in the frame (e1, e2, normal).
template <typename Real>
struct SeenOf {
    Real u, w;              ///< along e1 and e2
    Real facing;            ///< along the normal: n . v
    Real inverse_distance;  ///< 1 / distance to the viewer; 0 for an orthographic view
    /// Squared sine of the angle between normal and view direction.
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

/// Radial curvature: curvature along w, the view direction projected onto the tangent plane. DeCarlo et al.,
/// "Suggestive Contours for Conveying Shape", SIGGRAPH 2003; DeCarlo, Finkelstein & Rusinkiewicz, "Interactive
/// Rendering of Suggestive Contours with Temporal Coherence", NPAR 2004. Seen head-on (sine 0) w is undefined:
/// curvature, torsion and derivative are 0.
template <typename Real>
struct RadialOf {
    Real scaled;      ///< radial curvature times sine^2: zero wherever the radial curvature is, and defined everywhere
    Real curvature;   ///< k_r = h(w, w), w normalized
    Real torsion;     ///< h(w, w rotated by 90 degrees)
    Real derivative;  ///< sine times the derivative of k_r along w; bounded everywhere
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

/// View-dependent curvature, as it appears in the image, and its derivative along its principal direction. Judd, Durand
/// & Adelson, "Apparent Ridges for Line Drawing", SIGGRAPH 2007; derivative in closed form instead of finite
/// differences.
template <typename Real>
struct ViewCurvatureOf {
    Real squared;  ///< square of the maximum view-dependent curvature
    Real a1, a2;   ///< tangent (in e1, e2) that projects to the unit principal direction in the image; sign arbitrary
    Real derivative;  ///< of `squared` along (a1, a2), so its sign depends on theirs
};

/// |n . v| is clamped to at least `least_facing`, as the view-dependent curvature is infinite at contours.
template <typename Real>
ViewCurvatureOf<Real> view_curvature(const CurvatureOf<Real>& c, const SeenOf<Real>& seen,
                                     Real least_facing = Real(1e-3)) {
    // P^-1 = I + (1 / |n.v| - 1) w w^T, w unit; Q = S P^-1; the eigenvector of Q^T Q with the greater eigenvalue.
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
    } else {  // isotropic
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

/// Laplacian of n . v over the surface with v held constant: zero on Laplacian lines. Zhang et al., "Real-time
/// Feature-based Line Drawing with Laplacian lines", TVCG 2009; from the derivative of curvature instead of a mesh
/// Laplacian.
template <typename Real>
Real laplacian(const CurvatureOf<Real>& c, const SeenOf<Real>& seen) {
    return seen.u * (c.C[0] + c.C[2]) + seen.w * (c.C[1] + c.C[3]) - (c.k1 * c.k1 + c.k2 * c.k2) * seen.facing;
}

/// Squared length of the gradient of n . v over the surface.
template <typename Real>
Real gradient2(const CurvatureOf<Real>& c, const SeenOf<Real>& seen) {
    const Real x = c.k1 * seen.u, y = c.k2 * seen.w;
    return x * x + y * y;
}

/// The tangent direction along which curvature changes fastest. Kolomenkin, Shimshoni & Tal, "Demarcating Curves for
/// Shape Illustration", SIGGRAPH Asia 2008.
template <typename Real>
struct DemarcatingOf {
    Real g1, g2;     ///< unit tangent (in e1, e2) that maximizes C(g, g, g)
    Real curvature;  ///< h(g, g): zero on demarcating curves
    Real strength;   ///< C(g, g, g), >= 0
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
    Real operator()(Real t) const { return a * cosine(t) + b * sine(t) + p * cosine(3 * t) + q * sine(3 * t); }
    /// Angle of a local maximum, by Newton steps uphill from t, each limited to 0.2 radians.
    Real climb(Real t) const {
        Real before = t;
        for (int left = 19; left >= 0; --left) {
            const Real slope = -a * sine(t) + b * cosine(t) - 3 * p * sine(3 * t) + 3 * q * cosine(3 * t);
            const Real bend = -a * cosine(t) - b * sine(t) - 9 * p * cosine(3 * t) - 9 * q * sine(3 * t);
            const Real limit = Real(0.2);
            const Real move = bend < 0 ? std::clamp(-slope / bend, -limit, limit) : slope > 0 ? limit : -limit;
            const Real next = t + move;
            if (!(std::abs(move) > Real(1e-12)) || next == t) break;
            if (next == before) return left % 2 == 0 ? next : t;  // rounding: all other steps lead to and fro
            before = std::exchange(t, next);
        }
        return t;
    }
    const Real a, b, p, q;
};

template <typename Real>
DemarcatingOf<Real> demarcating_at(const CurvatureOf<Real>& c, Real angle, Real strength) {
    DemarcatingOf<Real> d{Real(cosine(angle)), Real(sine(angle)), 0, strength};
    d.curvature = c.k1 * d.g1 * d.g1 + c.k2 * d.g2 * d.g2;
    return d;
}

/// The same for the local maximum of C(g, g, g) near the tangent (x, y), which need not be the global one.
template <typename Real>
DemarcatingOf<Real> demarcating_near(const CurvatureOf<Real>& c, Real x, Real y) {
    const ThirdFormByAngle<Real> third(c);
    const Real t = third.climb(angle_of(y, x));
    return demarcating_at(c, t, third(t));
}

template <typename Real>
DemarcatingOf<Real> demarcating(const CurvatureOf<Real>& c) {
    // The global maximum is within 60 degrees of one of the three maxima of the second term.
    const ThirdFormByAngle<Real> value(c);
    constexpr Real third = Real(2.0943951023931953);
    const Real first = angle_of(value.q, value.p) / 3, mean = angle_of(value.b, value.a);
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
