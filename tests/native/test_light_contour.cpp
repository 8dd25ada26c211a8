// SPDX-License-Identifier: GPL-3.0-or-later
// Light contours of shapes in closed form, and what is blocked of them.
#include <gtest/gtest.h>

#include "shadows.h"

using namespace fovea;
using namespace fovea::draw;
using namespace fovea::drawing;
using namespace fovea::meshes;
using namespace fovea::shadows;

namespace {

const dvec3 slanted = glm::normalize(dvec3(0.5, -0.3, 1.0));

Lines contours_of(std::vector<Placement> placements, std::vector<Light> lights) {
    return Lines(std::move(placements), std::move(lights), line_set({"light_contour"}));
}

Mesh smooth_sphere(int n) {
    Mesh mesh = sphere(n);
    mesh.shape = Shape::smooth;
    return mesh;
}

}  // namespace

TEST(LightContour, OfASmoothSphereIsACircle) {
    const int n = 32;
    const double edge = std::numbers::pi / n;
    const dvec3 c(0.3, 0.2, 0.5), at = c + 3.0 * slanted;
    for (const Light& light : {sun(slanted), lamp(at)}) {
        const Lines found = contours_of({place(smooth_sphere(n), moved(c), 1)}, {light});
        EXPECT_EQ(found.closed, 1u);
        // Where the tangent plane goes through the light: at this height over the center, along the light.
        const double height = light.kind == Light::sun ? 0.0 : 1.0 / 3.0;
        const auto distance = [&](const dvec3& x) { return std::abs(glm::dot(x - c, slanted) - height) / edge; };
        const Errors errors(found.segments, 0.25, distance);
        EXPECT_LT(errors.median, 0.02);
        EXPECT_LT(errors.most, 0.05);
        EXPECT_EQ(errors.beyond, 0.0);
        EXPECT_NEAR(length(found.segments) / (2 * std::numbers::pi * std::sqrt(1 - height * height)), 1.0, 0.005);
    }
}

TEST(LightContour, OfABoxIsTheEdgesBetweenLitAndUnlitSides) {
    const Lines found = contours_of({place(box(), moved({0, 0, 3}), 1)}, {sun(slanted)});
    EXPECT_EQ(found.closed, 1u);
    EXPECT_NEAR(length(found.segments), 6 * 2.0, 1e-5);
    for (const Segment& s : found.segments) {
        const dvec3 p = s.middle() - dvec3(0, 0, 3);
        // The sides at +x, -y and +z are lit: each edge is on one of them and on one of the others.
        EXPECT_TRUE(p.x > 0.99 || p.y < -0.99 || p.z > 0.99);
        EXPECT_TRUE(p.x < -0.99 || p.y > 0.99 || p.z < -0.99);
    }
}

TEST(LightContour, IsOnlyWhereTheLightReaches) {
    const std::vector<Placement> placements = {
        place(smooth_sphere(24), dmat4(1.0), 1),
        place(box(), moved(6.0 * slanted + dvec3(0, 1, 0)) * scaled(dvec3(0.4)), 2)};
    const Lines alone = contours_of({placements[0]}, {sun(slanted)}), found = contours_of(placements, {sun(slanted)});
    const double whole = length(alone.segments), left = length(found.on(0));
    EXPECT_GT(left, 0.5 * whole);
    EXPECT_LT(left, 0.95 * whole);
    double dark = 0.0;
    for (const Segment& s : found.on(0))
        if (!is_lit(found.scene, found.scene.lights[0], s.middle(), 0)) dark += s.length();
    EXPECT_LT(dark, 0.005 * whole);
}

TEST(LightContour, IsNoneWhereABodyStandsOnAnother) {
    const Lines found =
        contours_of({place(box(), moved({0, 0, 1}), 1), place(grid(1, 20.0f), dmat4(1.0), 2)}, {sun(slanted)});
    for (const Segment& s : found.segments) EXPECT_GT(s.middle().z, 1e-3);
    EXPECT_NEAR(length(found.segments), 2 * 2.0 + 2 * 2.0, 5e-3);  // of the top, and upright ones
}

TEST(LightContour, TurnsStretchesAndMirrorsWithItsObject) {
    // A stretched sphere is an ellipsoid: where the sun is tangent is a plane section again.
    const dmat4 to_world = glm::rotate(moved({1, 2, 3}), 0.7, dvec3(1, 2, 3)) * scaled({2, -1, 0.5});
    const Lines found = contours_of({place(smooth_sphere(32), to_world, 1)}, {sun(slanted)});
    EXPECT_EQ(found.closed, 1u);
    const dvec3 conjugate = glm::transpose(glm::inverse(dmat3(to_world))) * (glm::inverse(dmat3(to_world)) * slanted);
    for (const Segment& s : found.segments)
        EXPECT_NEAR(glm::dot(glm::normalize(conjugate), s.middle() - dvec3(1, 2, 3)), 0.0, 0.02);
}

TEST(LightContour, IsNoneWithoutLights) {
    EXPECT_TRUE(contours_of({place(smooth_sphere(8))}, {}).segments.empty());
    EXPECT_TRUE(contours_of({place(smooth_sphere(8))}, {lamp({0.1, 0, 0})}).segments.empty());
    EXPECT_TRUE(contours_of({}, {sun(slanted)}).segments.empty());
}
