// SPDX-License-Identifier: GPL-3.0-or-later
// Polygons cut into triangles cover what they covered, whatever way they are turned.
#include <cmath>
#include <gtest/gtest.h>
#include <numbers>

#include <fovea/mesh/ears.h>

using namespace fovea;
using namespace fovea::draw;

namespace {

dvec3 area_of(const std::vector<vec3>& corners) {
    dvec3 sum(0.0);
    for (std::size_t i = 0; i < corners.size(); ++i)
        sum += glm::cross(dvec3(corners[i]), dvec3(corners[(i + 1) % corners.size()]));
    return sum / 2.0;
}

/// All triangles are turned as the polygon is, and together as large: they lie inside and do not overlap.
void expect_covered(const std::vector<vec3>& corners) {
    const std::vector<Triangle> triangles = cut_ears(corners);
    ASSERT_EQ(triangles.size(), corners.size() - 2);
    const dvec3 whole = area_of(corners);
    double sum = 0.0;
    for (const Triangle& t : triangles) {
        const dvec3 part = area_of({corners[t.x], corners[t.y], corners[t.z]});
        EXPECT_GE(glm::dot(part, whole), -1e-9);
        sum += glm::length(part);
    }
    EXPECT_NEAR(sum, glm::length(whole), 1e-5);
}

/// Tips and hollows by turns, in the plane of two axes.
std::vector<vec3> star(int tips, const vec3& right, const vec3& up) {
    std::vector<vec3> corners;
    for (int i = 0; i < 2 * tips; ++i) {
        const double a = std::numbers::pi * i / tips, r = i % 2 ? 0.3 : 1.0;
        corners.push_back(float(r * std::cos(a)) * right + float(r * std::sin(a)) * up);
    }
    return corners;
}

}  // namespace

TEST(CutEars, ConvexAndHollowPolygonsAreCoveredInEveryPlane) {
    const vec3 x(1, 0, 0), y(0, 1, 0), z(0, 0, 1);
    expect_covered({x, y, -x, -y});
    for (const auto& [right, up] : {std::pair(x, y), {y, x}, {y, z}, {z, x}, {x + y, z}, {z, -x - y}}) {
        expect_covered(star(5, right, up));
        expect_covered(star(60, right, up));
    }
}

TEST(CutEars, CornersInLineAndCornersOfHolesJoinedByABridgeAreCovered) {
    expect_covered({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {2, 2, 0}, {1, 2, 0}, {0, 2, 0}, {0, 1, 0}});
    expect_covered(
        {{0, 0, 0}, {9, 0, 0}, {9, 9, 0}, {0, 9, 0}, {0, 0, 0}, {3, 3, 0}, {3, 6, 0}, {6, 6, 0}, {6, 3, 0}, {3, 3, 0}});
}

TEST(CutEars, WhatHasNoInsideStillGivesAsManyTriangles) {
    EXPECT_EQ(cut_ears(std::vector<vec3>(7, vec3(1.0f))).size(), 5u);
    EXPECT_EQ(cut_ears(std::vector<vec3>{{0, 0, 0}, {1, 1, 0}, {1, 0, 0}, {0, 1, 0}, {0.5f, 2, 0}}).size(), 3u);
    const float nan = std::numeric_limits<float>::quiet_NaN();
    EXPECT_EQ(cut_ears(std::vector<vec3>(6, vec3(nan))).size(), 4u);
    EXPECT_TRUE(cut_ears(std::vector<vec3>(2, vec3(1.0f))).empty());
}
