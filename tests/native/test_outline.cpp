// SPDX-License-Identifier: GPL-3.0-or-later
// Outlines of strokes: their areas, and what textures of pens leave of themselves.
#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <numbers>

#include <fovea/draw/assets.h>
#include <fovea/vector/grain.h>
#include <fovea/vector/outline.h>

using namespace fovea;
using namespace fovea::vector;

namespace {

constexpr double pi = std::numbers::pi;

/// Area within curves, by the directions in which they run.
double area(const std::vector<Curve>& curves) {
    double twice = 0.0;
    for (const Curve& curve : curves) {
        const Points flat = flattened(curve, 1e-5);
        for (std::size_t i = 1; i < flat.size(); ++i) twice += cross(flat[i - 1], flat[i]);
    }
    return std::abs(twice) / 2.0;
}

Points arc(double radius, double to, int count) {
    Points points;
    for (int i = 0; i <= count; ++i)
        points.push_back(radius * dvec2(std::cos(to * i / count), std::sin(to * i / count)));
    return points;
}

}  // namespace

TEST(Outline, OfALineIsARectangleWithTheCapsOfThePen) {
    const Points line{{0, 0}, {4, 0}, {10, 0}};
    const std::vector<double> widths{2, 2, 2};
    EXPECT_NEAR(area(outline(line, widths, false, {false, false}, 0.01)), 20.0, 1e-3);
    EXPECT_NEAR(area(outline(line, widths, false, {true, false}, 0.01)), 20.0 + pi / 2.0, 2e-3);
    EXPECT_NEAR(area(outline(line, widths, false, {true, true}, 0.01)), 20.0 + pi, 2e-3);
}

TEST(Outline, HasRoundCapsOfOneCubicWhereThatIsNearEnough) {
    for (const double radius : {0.5, 0.6}) {
        const double tolerance = 0.01;
        const std::vector<double> widths{2.0 * radius, 2.0 * radius};
        const std::vector<Curve> curves = outline(Points{{0, 0}, {10, 0}}, widths, false, {true, true}, tolerance);
        std::size_t cubics = 0;
        for (const std::uint8_t cubic : curves.at(0).cubic) cubics += cubic;
        EXPECT_EQ(cubics, radius < 0.54 ? 2u : 4u);
        for (const dvec2& p : flattened(curves[0], 1e-5)) {
            const double x = std::clamp(p.x, 0.0, 10.0);
            EXPECT_NEAR(glm::distance(p, dvec2(x, 0.0)), radius, tolerance);
        }
    }
}

TEST(Outline, OfATaperIsATrapezoid) {
    const std::vector<Curve> taper = outline(Points{{0, 0}, {10, 0}}, std::vector<double>{0.5, 2}, false, {}, 0.01);
    EXPECT_NEAR(area(taper), 12.5, 1e-3);
    EXPECT_EQ(taper[0].cubic, std::vector<std::uint8_t>(4, 0));
}

TEST(Outline, OfACornerIsMitred) {
    const Points corner{{0, 0}, {10, 0}, {10, 10}};
    EXPECT_NEAR(area(outline(corner, std::vector<double>(3, 2.0), false, {}, 0.01)), 40.0, 0.05);
}

TEST(Outline, OfACircleIsARing) {
    const Points circle = arc(10.0, 2.0 * pi, 200);
    Points closed = circle;
    closed.back() = closed.front();
    const std::vector<Curve> ring = outline(closed, std::vector<double>(closed.size(), 2.0), true, {}, 0.01);
    ASSERT_EQ(ring.size(), 2u);
    EXPECT_NEAR(area(ring), pi * (121.0 - 81.0), 0.5);
}

TEST(Outline, OfABendTighterThanThePenHasNoSpikeInside) {
    // A hairpin of radius .3 by a pen 2 wide: a half disc around its middle, and the two sides.
    Points hairpin{{-10, -0.3}};
    for (int i = 0; i <= 40; ++i) {
        const double angle = pi * (i / 40.0 - 0.5);
        hairpin.push_back(0.3 * dvec2(std::cos(angle), std::sin(angle)));
    }
    hairpin.push_back({-10, 0.3});
    const auto curves = outline(hairpin, std::vector<double>(hairpin.size(), 2.0), false, {}, 0.01);
    for (const dvec2& p : flattened(curves[0], 1e-3)) {
        EXPECT_LT(p.x, 1.32);
        EXPECT_LT(std::abs(p.y), 1.32);
        EXPECT_GT(p.x, -10.01);
    }
}

TEST(Outline, OfNoLengthIsNone) {
    EXPECT_TRUE(outline(Points{{1, 1}, {1, 1}}, std::vector<double>{1, 1}, false, {true, true}, 0.01).empty());
}

TEST(Grain, OfDashesIsTheirLengths) {
    const Assets assets(FOVEA_ADDON);
    const Grain dashes = grain_of(&assets.texture("dashes")->ink);  // capsules 6 widths long of 8
    ASSERT_EQ(dashes.dashes.size(), 2u);
    EXPECT_NEAR(8.0 * dashes.dashes[0], 6.0, 0.1);
    EXPECT_NEAR(8.0 * dashes.dashes[1], 2.0, 0.1);
    EXPECT_NEAR(8.0 * dashes.first, 5.0, 0.1);  // one is in the middle of where the texture begins
    EXPECT_TRUE(dashes.round);
    EXPECT_EQ(grain_of(&assets.texture("dash_dot")->ink).dashes.size(), 4u);
    EXPECT_EQ(grain_of(&assets.texture("dots")->ink).dashes.size(), 2u);
    EXPECT_TRUE(grain_of(nullptr).dashes.empty());
}

TEST(Grain, OfInkIsHowWideAndDenseItIs) {
    const Assets assets(FOVEA_ADDON);
    for (const char* name : {"ink", "pencil", "charcoal", "chalk", "brush", "marker"}) {
        const Grain grain = grain_of(&assets.texture(name)->ink);
        EXPECT_TRUE(grain.dashes.empty()) << name;
        EXPECT_GT(grain.width * grain.opacity, 0.2) << name;
        EXPECT_LE(grain.width, 1.0) << name;
        EXPECT_LE(grain.opacity, 1.0) << name;
    }
}
