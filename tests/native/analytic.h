// SPDX-License-Identifier: GPL-3.0-or-later
// Surfaces with known derivatives of every order, and meshes of them.
#pragma once

#include <array>
#include <cmath>
#include <functional>
#include <numbers>
#include <random>

#include <fovea/field/exact_curvature.h>

#include "meshes.h"

namespace fovea::analytic {
using namespace draw;

using meshes::Mesh;

/// A mesh whose vertices lie on a surface, and the exact curvature of that surface at a point.
struct Sample {
    Mesh mesh;
    std::function<CurvatureD(const dvec3&)> exact;
    std::function<dvec3(double, double)> point;  ///< the whole surface, over [0,1]^2
};

struct GridOptions {
    int n = 64;              ///< cells along u; along v half as many on closed surfaces (a torus), else as many
    bool irregular = false;  ///< parameters jittered by .3 cell, random diagonals
    unsigned seed = 1;
};

/// point(u, v) over [0,1]^2, closed in both directions or in none; triangles, outward where point_u x point_v is.
template <typename Point>
Mesh parameter_grid(const std::string& name, bool closed, const GridOptions& options, const Point& point) {
    const int n = options.n, m = closed ? n / 2 : n, wide = closed ? n : n + 1, high = closed ? m : m + 1;
    std::mt19937 random(options.seed);
    std::uniform_real_distribution<double> jitter(-0.3, 0.3);
    Mesh mesh(name, {});
    for (int j = 0; j < high; ++j)
        for (int i = 0; i < wide; ++i) {
            const bool border = !closed && (i == 0 || j == 0 || i == n || j == m);
            const double a = jitter(random), b = jitter(random), move = options.irregular && !border ? 1.0 : 0.0;
            mesh.positions.push_back(vec3(point((i + move * a) / n, (j + move * b) / m)));
        }
    for (int j = 0; j < m; ++j)
        for (int i = 0; i < n; ++i) {
            const auto at = [&](int x, int y) { return x % wide + wide * (y % high); };
            const int a = at(i, j), b = at(i + 1, j), c = at(i + 1, j + 1), d = at(i, j + 1);
            const bool other = options.irregular && random() % 2;
            mesh.add_polygon(other ? std::vector{a, b, d} : std::vector{a, b, c});
            mesh.add_polygon(other ? std::vector{b, c, d} : std::vector{a, c, d});
        }
    return mesh;
}

/// At a point of any tube around a circle of radius `R` around z.
ImplicitJet torus_jet(const dvec3& p, double R);

/// Around z; tube of radius `r` around a circle of radius `R`.
Sample torus(const GridOptions& options, double R = 1.0, double r = 0.4);

/// z = sum of c sin(a x + b y + phase) over [-1,1]^2.
Sample waves(const GridOptions& options);

/// Unit sphere of 20 * 4^levels triangles from an icosahedron. Irregular: every vertex moved by up to a quarter of an
/// edge along each axis, and back to the sphere.
Mesh icosphere(int levels, bool irregular, unsigned seed = 1);

ImplicitJet ellipsoid_jet(const dvec3& p, const dvec3& axes);

/// Half axes 1.5, 1.1, .7; 20 * 4^levels triangles.
Sample ellipsoid(int levels, bool irregular, const dvec3& axes = dvec3(1.5, 1.1, .7));

}  // namespace fovea::analytic
