// SPDX-License-Identifier: GPL-3.0-or-later
// Chains made smooth: what moves, how far, and what must not.
#include <gtest/gtest.h>

#include <fovea/field/view_curvature.h>
#include <fovea/line/zero_set.h>
#include <fovea/mesh/triangle_sides.h>
#include <fovea/path/find_curves.h>
#include <fovea/path/smooth.h>

#include "analytic.h"
#include "drawing.h"
#include "rules.h"

using namespace fovea;
using namespace fovea::draw;

namespace {

/// The zero set of a function of positions, as chains.
template <typename Value>
CurveChains zero_set(const Surface& surface, const Value& value) {
    const auto one = [](auto) { return 1.0f; };
    return chain_curves(trace_zero_set(surface, [&](Index v) { return value(surface.positions[v], v); }, one, one));
}

/// Sum of the angles by which a chain turns.
double turning(const CurveChains& chains) {
    double sum = 0.0;
    for (Index c = 0; c < chains.rows.count(); ++c)
        for (Index i = chains.rows.begin(c) + 1; i + 1 < chains.rows.end(c); ++i) {
            const dvec3 a = dvec3(chains.point[i]) - dvec3(chains.point[i - 1]);
            const dvec3 b = dvec3(chains.point[i + 1]) - dvec3(chains.point[i]);
            if (glm::length(a) > 1e-9 && glm::length(b) > 1e-9)
                sum += std::acos(std::clamp(glm::dot(a, b) / glm::length(a) / glm::length(b), -1.0, 1.0));
        }
    return sum;
}

float noise(Index v) { return float(v * 2654435761u % 1000u) / 500.0f - 1.0f; }

}  // namespace

TEST(Smooth, PointsStayOnTheirSides) {
    const auto surface = analytic::waves({.n = 64, .irregular = true}).mesh.surface();
    const auto sides = triangle_sides(*surface);
    const CurveChains before = zero_set(*surface, [](const vec3& p, Index v) { return p.x - 0.2f + 0.01f * noise(v); });
    CurveChains after = before;
    const Smoothing options{.tolerance = 0.3};
    smooth(after, *surface, options);
    ASSERT_EQ(before.point.size(), after.point.size());
    double moved = 0.0;
    for (std::size_t i = 0; i < after.point.size(); ++i) {
        ASSERT_EQ(before.side[i], after.side[i]);
        if (after.side[i] == none) continue;
        const Edge e = sides->vertices[after.side[i]];
        const dvec3 a(surface->positions[e.x]), b(surface->positions[e.y]), p(after.point[i]);
        const double length = glm::distance(a, b), way = glm::distance(p, dvec3(before.point[i]));
        EXPECT_NEAR(glm::distance(a, p) + glm::distance(p, b), length, 1e-5 * length);
        EXPECT_LE(way, (options.tolerance + 1e-4) * length);
        moved = std::max(moved, way / length);
    }
    EXPECT_GT(moved, 0.1) << "noise is smoothed";
}

TEST(Smooth, AZigzagIsStraightened) {
    const int n = 40;
    const float cell = 2.0f / n;
    const auto surface = meshes::grid(n).surface();
    CurveChains line = zero_set(*surface, [&](const vec3& p, Index v) { return p.x - 0.02f + 0.3f * cell * noise(v); });
    const double before = turning(line);
    smooth(line, *surface);
    std::printf("[ figure ] turning %.2f, smoothed %.2f\n", before, turning(line));
    EXPECT_LT(turning(line), 0.35 * before);
}

TEST(Smooth, ExactLinesStay) {
    const int n = 40;
    const double cell = 2.0 / n;
    const auto surface = meshes::grid(n).surface();
    const auto unmoved = [&](const auto& value, double tolerance) {
        const CurveChains before = zero_set(*surface, value);
        CurveChains after = before;
        smooth(after, *surface);
        double most = 0.0;
        for (std::size_t i = 0; i < after.point.size(); ++i)
            most = std::max(most, std::abs(double(value(after.point[i], 0)) - double(value(before.point[i], 0))));
        EXPECT_LE(most, tolerance * cell);
    };
    unmoved([](const vec3& p, Index) { return p.x - 0.013f; }, 1e-4);
    unmoved([](const vec3& p, Index) { return p.x + 0.3f * p.y - 0.2f; }, 1e-3);
    unmoved([](const vec3& p, Index) { return std::hypot(p.x, p.y) - 0.6f; }, 0.02);
}

TEST(Smooth, TheExactPlaceOfSmoothContoursStays) {
    // To first order, in edge lengths, on waves whose contours are known; as TestCurves asks of single pieces.
    const int n = 256;
    const double edge = 2.0 / n;
    const dvec3 low = glm::normalize(dvec3(.9, .3, .25));
    for (const bool irregular : {false, true}) {
        const analytic::Sample sample = analytic::waves({.n = n, .irregular = irregular});
        const auto surface = sample.mesh.surface();
        SurfaceView seen{.surface = *surface};
        seen.eye_obj = low;
        seen.orthographic = true;
        const CurveChains chains = curves_of(rule_of<CurveRule>("smooth_contour"), seen, {0});
        std::vector<double> distances;
        for (const vec3& p : chains.point) {
            if (std::max(std::abs(p.x), std::abs(p.y)) > 0.95f) continue;
            const CurvatureD c = sample.exact(dvec3(p));
            const SeenOf<double> s = see(c, low, 0.0);
            distances.push_back(std::abs(s.facing) / std::sqrt(gradient2(c, s)) / edge);
        }
        ASSERT_GT(distances.size(), 200u);
        std::sort(distances.begin(), distances.end());
        const double half = distances[distances.size() / 2], most = distances[distances.size() * 9 / 10];
        std::printf("[ figure ] smoothed contour, %s: %.3f / %.3f edges\n", irregular ? "irregular" : "regular", half,
                    most);
        EXPECT_LE(half, .02);
        EXPECT_LE(most, .07);
    }
}

TEST(Smooth, ContoursLieOnTheSphereThatTheMeshStandsFor) {
    const auto surface = meshes::sphere(24).surface();
    SurfaceView seen{.surface = *surface};
    seen.eye_obj = glm::normalize(dvec3(3, -4, 2));
    seen.orthographic = true;
    const CurveChains chains = curves_of(rule_of<CurveRule>("smooth_contour"), seen, {1});
    ASSERT_EQ(chains.rows.count(), 1u);
    EXPECT_TRUE(chains.closed[0]);
    const double sagitta = 1.0 - std::cos(M_PI / 24);  // of the mesh's sides
    for (const vec3& p : chains.point) EXPECT_NEAR(glm::length(p), 1.0, 0.25 * sagitta);
}
