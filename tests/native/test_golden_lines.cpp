// SPDX-License-Identifier: GPL-3.0-or-later
// Field quantities at points of surfaces whose derivatives are known, against values found with another program.
#include <cmath>
#include <gtest/gtest.h>

#include <fovea/field/exact_curvature.h>
#include <fovea/field/view_curvature.h>

using namespace fovea;
using namespace fovea::draw;

namespace {

constexpr double exact = 1e-6;
const dvec3 golden_eye(2, 1.5, 3);

void near_to(double value, double expected, const char* what) {
    EXPECT_NEAR(value, expected, exact * std::max(1.0, std::abs(expected))) << what;
}

struct Golden {
    CurvatureD c{};
    SeenOf<double> seen;
    RadialOf<double> radial;
    ViewCurvatureOf<double> view;
    DemarcatingOf<double> demarcating;

    Golden(const ImplicitJet& jet, const dvec3& p) : c(curvature_of(jet)) {
        const dvec3 to_eye = golden_eye - p;
        const double distance = glm::length(to_eye);
        seen = see(c, to_eye / distance, 1.0 / distance);
        radial = fovea::field::radial(c, seen);
        view = view_curvature(c, seen);
        demarcating = fovea::field::demarcating(c);
        EXPECT_NEAR(glm::length(glm::cross(c.e1, c.e2) - c.normal), 0.0, 1e-12);
        EXPECT_GE(std::abs(c.k1), std::abs(c.k2));
    }
    dvec3 a() const { return view.a1 * c.e1 + view.a2 * c.e2; }
    /// The derivative of the radial curvature along W.
    double derivative() const { return radial.derivative / std::sqrt(seen.sine2()); }

    void is(double k1, double k2, double k_r, double torsion, double along_w, double lambda, double slope, double l,
            double h_gg) const {
        near_to(c.k1, k1, "k1");
        near_to(c.k2, k2, "k2");
        near_to(radial.curvature, k_r, "radial curvature");
        near_to(radial.torsion, torsion, "torsion");
        near_to(derivative(), along_w, "derivative of the radial curvature");
        near_to(view.squared, lambda, "squared view-dependent curvature");
        near_to(std::abs(view.derivative), std::abs(slope), "its derivative");
        near_to(laplacian(c, seen), l, "Laplacian");
        near_to(demarcating.curvature, h_gg, "curvature along g");
    }
    /// C, up to the sign of the frame.
    void third_is(double c0, double c1, double c2, double c3) const {
        const double expected[4] = {c0, c1, c2, c3};
        int most = 0;
        for (int i = 1; i < 4; ++i)
            if (std::abs(expected[i]) > std::abs(expected[most])) most = i;
        const double sign = c.C[most] * expected[most] < 0.0 ? -1.0 : 1.0;
        for (int i = 0; i < 4; ++i) near_to(sign * c.C[i], expected[i], "C");
    }
};

ImplicitJet implicit_ellipsoid(const dvec3& axes, const dvec3& p) {
    ImplicitJet jet;
    for (int i = 0; i < 3; ++i) {
        jet.gradient[i] = 2 * p[i] / (axes[i] * axes[i]);
        jet.hessian[i][i] = 2 / (axes[i] * axes[i]);
    }
    return jet;
}

/// F = (sqrt(x^2 + y^2) - R)^2 + z^2 - r^2 = x^2 + y^2 + z^2 - 2 R q + ..., q = sqrt(x^2 + y^2).
ImplicitJet torus(double big, const dvec3& p) {
    ImplicitJet jet;
    const double q = std::hypot(p.x, p.y), q3 = q * q * q, q5 = q3 * q * q;
    const double x[2] = {p.x, p.y};
    const auto d = [](int i, int j) { return i == j ? 1.0 : 0.0; };
    jet.gradient = {2 * p.x - 2 * big * p.x / q, 2 * p.y - 2 * big * p.y / q, 2 * p.z};
    jet.hessian[2][2] = 2;
    for (int i = 0; i < 2; ++i)
        for (int j = 0; j < 2; ++j) {
            jet.hessian[i][j] = 2 * d(i, j) - 2 * big * (d(i, j) / q - x[i] * x[j] / q3);
            for (int k = 0; k < 2; ++k)
                jet.third[k][i][j] =
                    -2 * big * (3 * x[i] * x[j] * x[k] / q5 - (d(i, j) * x[k] + d(i, k) * x[j] + d(j, k) * x[i]) / q3);
        }
    return jet;
}

dvec3 torus_point(double big, double small, double theta, double phi) {
    const double q = big + small * std::cos(theta);
    return {q * std::cos(phi), q * std::sin(phi), small * std::sin(theta)};
}

/// F = z - f(x, y) from f's derivatives.
ImplicitJet height(dvec2 f, double fxx, double fxy, double fyy, double fxxx, double fxxy, double fxyy, double fyyy) {
    ImplicitJet jet;
    jet.gradient = {-f.x, -f.y, 1};
    jet.hessian[0][0] = -fxx;
    jet.hessian[0][1] = jet.hessian[1][0] = -fxy;
    jet.hessian[1][1] = -fyy;
    jet.third[0][0][0] = -fxxx;
    jet.third[0][0][1] = jet.third[0][1][0] = jet.third[1][0][0] = -fxxy;
    jet.third[0][1][1] = jet.third[1][0][1] = jet.third[1][1][0] = -fxyy;
    jet.third[1][1][1] = -fyyy;
    return jet;
}

double waves(double x, double y, ImplicitJet& jet) {
    const double waves[3][4] = {{.10, 4, 1, .3}, {.08, -1.5, 5, 1.1}, {.05, 3, -4, 2}};
    double z = 0, d[10] = {};
    for (const auto& [c, a, b, phase] : waves) {
        const double s = c * std::sin(a * x + b * y + phase), k = c * std::cos(a * x + b * y + phase);
        z += s;
        d[0] += a * k, d[1] += b * k;
        d[2] -= a * a * s, d[3] -= a * b * s, d[4] -= b * b * s;
        d[5] -= a * a * a * k, d[6] -= a * a * b * k, d[7] -= a * b * b * k, d[8] -= b * b * b * k;
    }
    jet = height({d[0], d[1]}, d[2], d[3], d[4], d[5], d[6], d[7], d[8]);
    return z;
}

}  // namespace

TEST(GoldenLines, Ellipsoid) {
    const dvec3 axes(1.5, 1.1, .7), p(1.5 * cos(.6) * cos(.5), 1.1 * cos(.6) * sin(.5), .7 * sin(.6));
    const Golden e(implicit_ellipsoid(axes, p), p);
    e.is(1.142469809, .639133577, .834830638, .245365201, -2.230180418, 1.323914673, 5.565000731, -2.123808204,
         1.111646413);
    e.third_is(-2.157191459, .359730104, -.402266937, .603733034);
    near_to(e.seen.facing, .982263895, "n.v");
    near_to(std::abs(e.seen.u), .116915722, "u");
    near_to(std::abs(e.seen.w), .146589066, "w");
    near_to(e.demarcating.strength, 2.293561820, "C(g, g, g)");
    const double sign = e.a().x < 0 ? -1 : 1;
    near_to(glm::length(sign * e.a() - dvec3(.453467534, .688737682, -.578595828)), 0.0, "a");
    near_to(sign * e.view.derivative, 5.565000731, "derivative along a");
}

TEST(GoldenLines, Torus) {
    const dvec3 p1 = torus_point(1, .4, 2, .4), p2 = torus_point(1, .4, 1, -.7);
    const Golden first(torus(1, p1), p1), second(torus(1, p2), p2);
    first.is(2.5, -.499251631, 2.340738246, -.672533843, -.092618950, 19.732121667, -273.213379971, -.938090318,
             .500498912);
    first.third_is(0, 0, -3.271837765, 0);
    near_to(first.seen.facing, .552613726, "n.v");
    near_to(first.demarcating.strength, 3.777992829, "C(g, g, g)");
    near_to(second.c.k2, .444283373, "k2");
    near_to(second.radial.curvature, 1.266366087, "radial curvature");
    near_to(second.radial.torsion, 1.007049708, "torsion");
    near_to(second.derivative(), -2.837617175, "derivative");
    near_to(second.view.squared, 13.355586283, "squared view-dependent curvature");
    near_to(std::abs(second.view.derivative), 134.575048166, "its derivative");
    near_to(laplacian(second.c, second.seen), -4.090797644, "Laplacian");
    second.third_is(0, 0, 1.422412741, 0);
}

TEST(GoldenLines, Waves) {
    ImplicitJet jet;
    const double z = waves(.2, -.3, jet);
    const Golden w(jet, {.2, -.3, z});
    near_to(glm::length(w.c.normal - dvec3(-.060105726, -.470058071, .880586573)), 0.0, "normal");
    w.is(-1.506110307, .947594163, .104766112, -1.165200340, 1.406007410, 7.772807607, -65.529889962, 6.823866340,
         -1.488794389);
    w.third_is(-11.846239838, -1.203985624, .929679460, 4.500846630);
    near_to(w.demarcating.strength, 12.000066652, "C(g, g, g)");
    near_to(w.derivative() * std::sqrt(w.seen.sine2()) / w.seen.facing, 2.949091630, "tan times the derivative");
    const double sign = w.a().x < 0 ? -1 : 1;
    near_to(glm::length(sign * w.a() - dvec3(.997128796, 1.766001846, 1.010754193)), 0.0, "a");
    near_to(sign * w.view.derivative, -65.529889962, "derivative along a");
}

TEST(GoldenLines, Monge) {
    // z = .5 x^2 - .3 y^2 + .2 x^3 + .3 x^2 y - .4 x y^2 + .1 y^3
    const Golden m(height({0, 0}, 1, 0, -.6, 1.2, .6, -.8, .6), dvec3(0));
    m.is(-1, .6, -.424, .768, -2.1595776, 1.483160594, -6.789549320, -1.710572716, .169700364);
    m.third_is(-1.2, -.6, .8, -.6);
}

TEST(GoldenLines, HeadOnAndFlatPointsStayFinite) {
    for (const double k : {0.0, 1.0}) {
        CurvatureD c{};
        c.normal = {0, 0, 1};
        c.e1 = {1, 0, 0};
        c.e2 = {0, 1, 0};
        c.k1 = c.k2 = k;
        for (const dvec3& towards : {dvec3(0, 0, 1), dvec3(1, 0, 0), dvec3(0, 0, -1)}) {
            const auto seen = see(c, towards, 0.0);
            const auto r = radial(c, seen);
            const auto v = view_curvature(c, seen);
            const auto d = demarcating(c);
            for (const double value : {r.scaled, r.curvature, r.torsion, r.derivative, v.squared, v.a1, v.a2,
                                       v.derivative, d.g1, d.g2, d.curvature, d.strength, laplacian(c, seen)})
                EXPECT_TRUE(std::isfinite(value));
        }
    }
}
