// SPDX-License-Identifier: GPL-3.0-or-later
#include "analytic.h"

namespace fovea::analytic {
using namespace draw;

ImplicitJet torus_jet(const dvec3& p, double R) {
    ImplicitJet jet;
    const double rho = std::hypot(p.x, p.y), x = p.x, y = p.y;
    // F = (rho - R)^2 + z^2 - r^2 = x^2 + y^2 + z^2 + R^2 - r^2 - 2 R rho
    const double rho3 = rho * rho * rho, rho5 = rho3 * rho * rho;
    jet.gradient = 2.0 * p - 2.0 * R * dvec3(x / rho, y / rho, 0.0);
    jet.hessian = dmat3(2.0);
    const double hxx = y * y / rho3, hxy = -x * y / rho3, hyy = x * x / rho3;  // of rho
    jet.hessian -= 2.0 * R * dmat3(hxx, hxy, 0, hxy, hyy, 0, 0, 0, 0);
    const double xxx = -3.0 * x * y * y / rho5, xxy = y * (2.0 * x * x - y * y) / rho5;
    const double xyy = x * (2.0 * y * y - x * x) / rho5, yyy = -3.0 * y * x * x / rho5;
    jet.third[0] = -2.0 * R * dmat3(xxx, xxy, 0, xxy, xyy, 0, 0, 0, 0);
    jet.third[1] = -2.0 * R * dmat3(xxy, xyy, 0, xyy, yyy, 0, 0, 0, 0);
    return jet;
}

Sample torus(const GridOptions& options, double R, double r) {
    const auto point = [=](double u, double v) {
        const double a = 2.0 * std::numbers::pi * u, b = 2.0 * std::numbers::pi * v, d = R + r * std::cos(b);
        return dvec3(d * std::cos(a), d * std::sin(a), r * std::sin(b));
    };
    return {parameter_grid("torus", true, options, point),
            [=](const dvec3& p) { return curvature_of(torus_jet(p, R)); }, point};
}

Sample waves(const GridOptions& options) {
    struct Wave {
        double c, a, b, phase;
    };
    static constexpr Wave all[] = {{.10, 4, 1, .3}, {.08, -1.5, 5, 1.1}, {.05, 3, -4, 2}};
    const auto point = [](double u, double v) {
        dvec3 p(2.0 * u - 1.0, 2.0 * v - 1.0, 0.0);
        for (const Wave& w : all) p.z += w.c * std::sin(w.a * p.x + w.b * p.y + w.phase);
        return p;
    };
    const auto exact = [](const dvec3& p) {
        ImplicitJet jet;
        jet.gradient = dvec3(0, 0, 1);
        for (const Wave& w : all) {
            const double angle = w.a * p.x + w.b * p.y + w.phase;
            const dvec3 k(w.a, w.b, 0);
            jet.gradient -= w.c * std::cos(angle) * k;
            jet.hessian += w.c * std::sin(angle) * glm::outerProduct(k, k);
            for (int i = 0; i < 2; ++i) jet.third[i] += w.c * std::cos(angle) * k[i] * glm::outerProduct(k, k);
        }
        return curvature_of(jet);
    };
    return {parameter_grid("waves", false, options, point), exact, point};
}

Mesh icosphere(int levels, bool irregular, unsigned seed) {
    const double g = std::numbers::phi;
    std::vector<dvec3> p{{-1, g, 0},  {1, g, 0},  {-1, -g, 0}, {1, -g, 0}, {0, -1, g},  {0, 1, g},
                         {0, -1, -g}, {0, 1, -g}, {g, 0, -1},  {g, 0, 1},  {-g, 0, -1}, {-g, 0, 1}};
    std::vector<glm::ivec3> triangles{{0, 11, 5}, {0, 5, 1},  {0, 1, 7},   {0, 7, 10}, {0, 10, 11},
                                      {1, 5, 9},  {5, 11, 4}, {11, 10, 2}, {10, 7, 6}, {7, 1, 8},
                                      {3, 9, 4},  {3, 4, 2},  {3, 2, 6},   {3, 6, 8},  {3, 8, 9},
                                      {4, 9, 5},  {2, 4, 11}, {6, 2, 10},  {8, 6, 7},  {9, 8, 1}};
    for (dvec3& q : p) q = glm::normalize(q);
    for (int level = 0; level < levels; ++level) {
        std::map<std::pair<int, int>, int> middles;
        const auto middle = [&](int a, int b) {
            const auto [it, added] = middles.try_emplace({std::min(a, b), std::max(a, b)}, int(p.size()));
            if (added) p.push_back(glm::normalize(p[a] + p[b]));
            return it->second;
        };
        std::vector<glm::ivec3> finer;
        for (const glm::ivec3& t : triangles) {
            const int a = middle(t.x, t.y), b = middle(t.y, t.z), c = middle(t.z, t.x);
            for (const glm::ivec3& f : {glm::ivec3(t.x, a, c), {t.y, b, a}, {t.z, c, b}, {a, b, c}}) finer.push_back(f);
        }
        triangles = std::move(finer);
    }
    const double edge = std::sqrt(4.0 * std::numbers::pi / double(triangles.size()) * 4.0 / std::sqrt(3.0));
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> jitter(-0.25 * edge, 0.25 * edge);
    Mesh mesh("icosphere", {});
    for (dvec3& q : p) {
        const double z = jitter(random), y = jitter(random), x = jitter(random);
        const dvec3 move(x, y, z);
        mesh.positions.push_back(vec3(glm::normalize(q + (irregular ? move : dvec3(0)))));
    }
    for (const glm::ivec3& t : triangles) mesh.add_polygon({t.x, t.y, t.z});
    return mesh;
}

ImplicitJet ellipsoid_jet(const dvec3& p, const dvec3& axes) {
    ImplicitJet jet;
    jet.gradient = 2.0 * p / (axes * axes);
    for (int i = 0; i < 3; ++i) jet.hessian[i][i] = 2.0 / (axes[i] * axes[i]);
    return jet;
}

Sample ellipsoid(int levels, bool irregular, const dvec3& axes) {
    Mesh mesh = icosphere(levels, irregular);
    mesh.name = "ellipsoid";
    for (vec3& p : mesh.positions) p = vec3(dvec3(p) * axes);
    const auto point = [=](double u, double v) {
        const double a = 2.0 * std::numbers::pi * u, b = std::numbers::pi * (v - 0.5);
        return axes * dvec3(std::cos(b) * std::cos(a), std::cos(b) * std::sin(a), std::sin(b));
    };
    return {std::move(mesh), [=](const dvec3& p) { return curvature_of(ellipsoid_jet(p, axes)); }, point};
}

}  // namespace fovea::analytic
