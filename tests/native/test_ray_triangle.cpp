// SPDX-License-Identifier: GPL-3.0-or-later
// Rays and triangles, one by one: closed forms, and that nothing passes between triangles that share a side.
#include <gtest/gtest.h>
#include <random>

#include <fovea/scene/ray_triangle.h>

using namespace fovea;
using namespace fovea::scene;

namespace {

bool hit(const ShearedRay& ray, vec3 a, vec3 b, vec3 c) {
    TriangleHit found;
    return meets(ray, a, b, c, found);
}

}  // namespace

TEST(RayTriangle, TellsDistanceAndWeightsAlongEachAxisFromBothSides) {
    const vec3 a(1, 0, 0), b(0, 2, 0), c(0, 0, 3);
    const dvec3 target = 0.5 * dvec3(a) + 0.3 * dvec3(b) + 0.2 * dvec3(c);
    for (const dvec3& along : {dvec3(3, 1, 0.5), dvec3(-1, 4, 2), dvec3(0.1, 0.2, -2), dvec3(-5, -1, -1)})
        for (const double t : {0.5, 2.0, 1e3}) {
            TriangleHit found;
            ASSERT_TRUE(meets(ShearedRay(target - t * along, along), a, b, c, found));
            EXPECT_NEAR(found.t, t, 1e-12 * t);
            EXPECT_NEAR(found.u, 0.3, 1e-9);
            EXPECT_NEAR(found.v, 0.2, 1e-9);
        }
}

TEST(RayTriangle, OneInThePlaneOfTheTriangleOrBesideItDoesNotMeetIt) {
    const vec3 a(0, 0, 0), b(1, 0, 0), c(0, 1, 0);
    EXPECT_FALSE(hit(ShearedRay({-1, 0.25, 0}, {1, 0, 0}), a, b, c));
    EXPECT_FALSE(hit(ShearedRay({0.6, 0.6, 1}, {0, 0, -1}), a, b, c));
    EXPECT_FALSE(hit(ShearedRay({0.25, 0.25, 1}, {0, 0, -1}), a, a, c)) << "no area";
    EXPECT_TRUE(hit(ShearedRay({0.5, 0.5, 1}, {0, 0, -1}), a, b, c)) << "on its side";
    EXPECT_TRUE(hit(ShearedRay({0, 0, 1}, {0, 0, -1}), a, b, c)) << "at its corner";
}

TEST(RayTriangle, NoRayPassesThroughTheSidesOrCornersOfAClosedFan) {
    std::mt19937 random(7);
    std::uniform_real_distribution<float> any(-1.0f, 1.0f);
    for (int trial = 0; trial < 2000; ++trial) {
        const vec3 middle(0.1f * any(random), 0.1f * any(random), 0.3f * any(random));
        std::vector<vec3> around;
        for (int k = 0; k < 7; ++k) {
            const float angle = 6.2831853f * (k + 0.3f * any(random)) / 7.0f;
            around.emplace_back(2.0f * std::cos(angle), 2.0f * std::sin(angle), 0.2f * any(random));
        }
        // Through the middle, and through a point of a spoke, rounded as rays are.
        const float share = 0.5f * std::abs(any(random));
        for (const vec3 target : {middle, glm::mix(middle, around[trial % 7], share)}) {
            const vec3 eye(3.0f * any(random), 3.0f * any(random), 5.0f);
            const ShearedRay ray(dvec3(eye), dvec3(target - eye));
            int met = 0;
            for (int k = 0; k < 7; ++k) met += hit(ray, middle, around[k], around[(k + 1) % 7]);
            EXPECT_GE(met, 1) << trial;
        }
    }
}

TEST(RayTriangle, FacingDoesNotMatterAndTheOrderOfCornersOnlyForWeights) {
    std::mt19937 random(11);
    std::uniform_real_distribution<float> any(-1.0f, 1.0f);
    const auto point = [&] { return vec3(any(random), any(random), any(random)); };
    int met = 0;
    for (int trial = 0; trial < 5000; ++trial) {
        const vec3 a = point(), b = point(), c = point(), eye = 3.0f * point();
        const ShearedRay ray(dvec3(eye), dvec3(0.3f * point() - eye));
        TriangleHit one, other;
        const bool first = meets(ray, a, b, c, one);
        ASSERT_EQ(first, meets(ray, c, b, a, other));
        if (!first) continue;
        ++met;
        EXPECT_NEAR(one.t, other.t, 1e-9 * std::abs(one.t));
        EXPECT_NEAR(one.v, 1.0 - other.u - other.v, 1e-6);
    }
    EXPECT_GT(met, 200);
}
