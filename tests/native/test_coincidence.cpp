// SPDX-License-Identifier: GPL-3.0-or-later
// Intersections of surfaces that run beside each other: none where only their triangles differ, all where they part.
#include <gtest/gtest.h>

#include "intersections.h"

using namespace fovea;
using namespace fovea::intersections;

namespace {

/// A square of `size` around the origin in n by n quads, its z a function of x and y.
template <typename Height>
Mesh relief(int n, double size, const Height& height) {
    Mesh mesh = grid(n, 1);
    float widest = 0.0f;
    for (const vec3& p : mesh.positions) widest = std::max(widest, std::abs(p.x));
    for (vec3& p : mesh.positions) {
        const dvec2 at = dvec2(p) * (0.5 * size / widest);
        p = vec3(dvec3(at, height(at.x, at.y)));
    }
    return mesh;
}

double hills(double x, double y) { return 0.3 * std::sin(1.3 * x) * std::cos(1.1 * y); }

}  // namespace

TEST(Coincidence, TwoMeshesOfOneShapeDoNotIntersect) {
    for (const int n : {23, 37, 61}) {
        const Found found(
            {put(relief(60, 6.0, hills), dmat4(1.0), 1), put(relief(n, 6.01, hills), moved({0.013, 0.017, 0.0}), 2)});
        EXPECT_EQ(found.count, 0u) << n;
    }
}

TEST(Coincidence, ADecalLaidOnAWallDoesNotIntersectIt) {
    const Found found({put(relief(6, 3.0, [](double, double) { return 0.0; }), dmat4(1.0), 1),
                       put(relief(1, 1.0, [](double, double) { return 0.0; }), turned(4e-4, {1, 0.7, 0}), 2)});
    EXPECT_EQ(found.count, 0u);
}

TEST(Coincidence, ABeachOfOneInTwentyMeetsTheSeaInOneLine) {
    for (const int n : {1, 8, 40}) {
        const auto sand = [](double x, double) { return 0.05 * x; };
        const Found found({put(relief(n, 3.0, sand), dmat4(1.0), 1),
                           put(relief(1, 4.0, [](double, double) { return 0.0; }), moved({0.0, 0.0, 0.011}), 2)});
        EXPECT_EQ(found.count, 1u) << n;
        EXPECT_NEAR(found.length, 3.0, 1e-4) << n;
    }
}

TEST(Coincidence, ABallThatDipsIntoAFloorHasItsCircle) {
    const Found found({put(relief(1, 4.0, [](double, double) { return 0.0; }), dmat4(1.0), 1),
                       put(sphere(64), moved({0.0, 0.0, 0.98}), 2)});
    EXPECT_EQ(found.count, 1u);
    EXPECT_EQ(found.closed, 1u);
    EXPECT_NEAR(found.length, 2.0 * std::numbers::pi * std::sqrt(1.0 - 0.98 * 0.98), 0.03);
}

TEST(Coincidence, ARoadOnAGroundMeetsItOnlyWhereTheyPart) {
    // Beside each other for negative x; then the road rises, at 1 in 5.
    const auto road = [](double x, double y) { return hills(x, y) + std::max(0.0, 0.2 * (x - 0.01)) - 1e-4; };
    const Found found({put(relief(60, 6.0, hills), dmat4(1.0), 1), put(relief(90, 5.99, road), dmat4(1.0), 2)});
    for (const dvec3& p : found.at) EXPECT_GT(p.x, -0.25);
    EXPECT_LE(found.count, 3u);
}
