// SPDX-License-Identifier: GPL-3.0-or-later
// The judge of lines, judged: where curves have a closed form, the exact ones have it, too.
#include <gtest/gtest.h>

#include "exact_lines.h"

using namespace fovea;
using namespace fovea::draw;
using namespace fovea::analytic;

TEST(ExactCurves, OfATorusHaveTheirClosedForms) {
    constexpr double R = 1.0, r = 0.4, beta = 0.7;
    const Sample sample = torus({.n = 8}, R, r);
    const ExactGrid grid(sample);
    const dvec3 view(std::sin(beta), 0, std::cos(beta));
    struct {
        const char* name;
        std::function<double(double, double)> zero;  // of theta, around the tube, and phi, around the axis
    } const forms[] = {
        {"smooth_contour",
         [&](double t, double p) { return std::sin(t) * std::cos(beta) + std::cos(t) * std::cos(p) * std::sin(beta); }},
        {"principal_highlight_ridge",
         [&](double t, double p) { return std::sin(t) * std::cos(p) * std::sin(beta) - std::cos(t) * std::cos(beta); }},
        {"parabolic", [](double t, double) { return std::cos(t); }},
        {"suggestive_contour",
         [&](double t, double p) {
             const double along = std::cos(t) * std::cos(beta) - std::sin(t) * std::cos(p) * std::sin(beta);
             const double across = -std::sin(p) * std::sin(beta);
             return along * along / r + across * across * std::cos(t) / (R + r * std::cos(t));
         }},
        {"laplacian_line", [&](double t, double p) {
             const double d = R + r * std::cos(t), k = std::cos(t) / d;
             const double along = std::cos(t) * std::cos(beta) - std::sin(t) * std::cos(p) * std::sin(beta);
             const double facing = std::cos(t) * std::cos(p) * std::sin(beta) + std::sin(t) * std::cos(beta);
             return -R * std::sin(t) / (r * d * d) * along - (1 / (r * r) + k * k) * facing;
         }}};
    for (const auto& form : forms) {
        Values values = defaults(form.name);
        if (!values.empty()) values[0] = 0.0;
        const ExactCurves curves = exact_curves(grid, exact_line(form.name, values, 0.05), {view});
        EXPECT_GT(length(curves), 0.5) << form.name;
        for (const ExactSegment& s : curves) {
            const double theta = std::atan2(s.a.z, std::hypot(s.a.x, s.a.y) - R), phi = std::atan2(s.a.y, s.a.x);
            ASSERT_NEAR(form.zero(theta, phi), 0.0, 1e-4) << form.name;
        }
    }
}

TEST(ExactCurves, OfAnEllipsoidHaveTheirClosedForms) {
    const dvec3 axes(1.5, 1.1, .7), eye(3, 2, 4);
    const Sample sample = ellipsoid(1, false);
    const ExactGrid grid(sample);
    const ExactCurves contour = exact_curves(grid, exact_line("smooth_contour", {}, 1.0), {eye, false});
    EXPECT_GT(length(contour), 6.0);
    for (const ExactSegment& s : contour) ASSERT_NEAR(glm::dot(s.a, eye / (axes * axes)), 1.0, 1e-4);
    const ExactCurves ridge = exact_curves(grid, exact_line("ridge", {0.0, 1.0, 0.0, 0.0}, 1.0), {eye, false});
    for (const ExactSegment& s : ridge) ASSERT_NEAR(s.a.z, 0.0, 1e-4);
    EXPECT_NEAR(length(ridge), 8.2165, 0.002) << "the long rim";
}
