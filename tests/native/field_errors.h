// SPDX-License-Identifier: GPL-3.0-or-later
// Errors of estimated curvature against the exact one.
#pragma once

#include <gtest/gtest.h>

#include "analytic.h"

namespace fovea::analytic {
using namespace draw;

/// Of k relative to |k1| at the point (the larger of the two), of C relative to the RMS of |C| over the surface.
struct Errors {
    double k_median = 0, k_99 = 0, c_median = 0, c_99 = 0;
};

/// |C| as a tensor.
template <typename Real>
double norm(const Real (&c)[4]) {
    return std::sqrt(c[0] * c[0] + 3 * c[1] * c[1] + 3 * c[2] * c[2] + c[3] * c[3]);
}

/// The estimate's C in the frame (x, y) of the exact one: both are compared as tensors, whatever their frames.
inline void in_frame(const Curvature& c, const dvec3& x, const dvec3& y, double (&out)[4]) {
    const double x1 = glm::dot(x, dvec3(c.e1)), x2 = glm::dot(x, dvec3(c.e2));
    const double y1 = glm::dot(y, dvec3(c.e1)), y2 = glm::dot(y, dvec3(c.e2));
    const auto at = [&](double a1, double a2, double b1, double b2, double d1, double d2) {
        return c.C[0] * a1 * b1 * d1 + c.C[1] * (a1 * b1 * d2 + a1 * b2 * d1 + a2 * b1 * d1) +
               c.C[2] * (a1 * b2 * d2 + a2 * b1 * d2 + a2 * b2 * d1) + c.C[3] * a2 * b2 * d2;
    };
    out[0] = at(x1, x2, x1, x2, x1, x2);
    out[1] = at(x1, x2, x1, x2, y1, y2);
    out[2] = at(x1, x2, y1, y2, y1, y2);
    out[3] = at(y1, y2, y1, y2, y1, y2);
}

/// Over the vertices for which `count(position)` holds.
template <typename Count>
Errors errors_of(const Sample& sample, const Array<Curvature>& found, const Count& count) {
    std::vector<double> k, c;
    double squares = 0.0;
    for (std::size_t v = 0; v < found.size(); ++v) {
        const dvec3 p(sample.mesh.positions[v]);
        if (!count(p)) continue;
        const CurvatureD exact = sample.exact(p);
        k.push_back(std::max(std::abs(found[v].k1 - exact.k1), std::abs(found[v].k2 - exact.k2)) / std::abs(exact.k1));
        double third[4];
        in_frame(found[v], exact.e1, exact.e2, third);
        for (int i = 0; i < 4; ++i) third[i] -= exact.C[i];
        c.push_back(norm(third));
        squares += norm(exact.C) * norm(exact.C);
    }
    const double scale = std::sqrt(squares / double(c.size()));
    for (double& e : c) e /= scale;
    std::sort(k.begin(), k.end());
    std::sort(c.begin(), c.end());
    const auto at = [](const std::vector<double>& e, double q) { return e[std::size_t(q * double(e.size() - 1))]; };
    return {at(k, .5), at(k, .99), at(c, .5), at(c, .99)};
}

inline Errors errors_of(const Sample& sample, const Array<Curvature>& found) {
    return errors_of(sample, found, [](const dvec3&) { return true; });
}

inline void expect_below(const Errors& e, double k_median, double k_99, double c_median, double c_99) {
    EXPECT_LE(e.k_median, k_median);
    EXPECT_LE(e.k_99, k_99);
    EXPECT_LE(e.c_median, c_median);
    EXPECT_LE(e.c_99, c_99);
}

}  // namespace fovea::analytic
