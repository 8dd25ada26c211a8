// SPDX-License-Identifier: GPL-3.0-or-later
// Polylines as lines and cubics: what is straight, round or sharp, and the bound on any polyline.
#include <cmath>
#include <gtest/gtest.h>
#include <limits>
#include <numbers>
#include <random>

#include <fovea/vector/fit.h>
#include <fovea/vector/fit_cubic.h>

using namespace fovea;
using namespace fovea::vector;

namespace {

constexpr double tolerance = 0.02;

Points circle(double radius, int count, double from = 0.0, double to = 2.0 * std::numbers::pi) {
    Points points;
    for (int i = 0; i <= count; ++i) {
        const double angle = from + (to - from) * i / count;
        points.push_back(radius * dvec2(std::cos(angle), std::sin(angle)));
    }
    if (to - from > 6.28) points.back() = points.front();
    return points;
}

/// Distance of a point from the lines through others.
double distance(const dvec2& p, const Points& line) {
    double nearest = std::numeric_limits<double>::infinity();
    for (std::size_t i = 1; i < line.size(); ++i)
        nearest = std::min(nearest, distance_to_segment(p, line[i - 1], line[i]));
    return nearest;
}

/// The larger of the distances between a polyline and a curve, each from any point of one to the other.
double error(const Points& line, const Curve& curve) {
    const Points flat = flattened(curve, 1e-5);
    double worst = 0.0;
    for (const dvec2& p : line) worst = std::max(worst, distance(p, flat));
    for (const dvec2& p : flat) worst = std::max(worst, distance(p, line));
    return worst;
}

void expect_fits(const Points& line, const Curve& curve) {
    ASSERT_FALSE(curve.empty());
    EXPECT_EQ(curve.start(), curve.closed ? curve.end() : line.front());
    EXPECT_EQ(curve.end(), curve.closed ? curve.start() : line.back());
    EXPECT_LE(error(line, curve), tolerance + 1e-5);
}

}  // namespace

TEST(Fit, OfALineIsALineHoweverManyPointsItHas) {
    Points line;
    for (int i = 0; i <= 100; ++i) line.push_back({0.3 * i, 0.1 * i});
    const Curve curve = fit(line, false, tolerance);
    EXPECT_EQ(curve.cubic, std::vector<std::uint8_t>{0});
    EXPECT_EQ(curve.points, (Points{line.front(), line.back()}));
}

TEST(Fit, OfACircleIsAFewCubicsThatJoinSmoothly) {
    const Points line = circle(50.0, 720);
    const Curve curve = fit(line, true, tolerance);
    expect_fits(line, curve);
    EXPECT_TRUE(curve.closed);
    EXPECT_LE(curve.cubic.size(), 5u);
    for (std::size_t i = 3; i < curve.points.size(); i += 3) {
        const dvec2 before = curve.points[i] - curve.points[i - 1];
        const dvec2 after = (i + 1 < curve.points.size() ? curve.points[i + 1] : curve.points[1]) - curve.points[i];
        EXPECT_LT(std::abs(cross(glm::normalize(before), glm::normalize(after))), 1e-6);
    }
}

TEST(Fit, OfAQuarterOfACircleIsOneCubicLikeTheBestKnown) {
    const Points line = circle(10.0, 90, 0.0, std::numbers::pi / 2.0);
    const Curve curve = fit(line, false, tolerance);
    expect_fits(line, curve);
    ASSERT_EQ(curve.cubic, std::vector<std::uint8_t>{1});
    EXPECT_LT(glm::distance(curve.points[1], dvec2(10.0, 5.52)), 0.2);
}

TEST(Fit, KeepsCorners) {
    Points line;
    for (int i = 0; i <= 20; ++i) line.push_back({0.5 * i, 0.0});
    for (int i = 1; i <= 20; ++i) line.push_back({10.0, 0.5 * i});
    const Curve curve = fit(line, false, tolerance);
    EXPECT_EQ(curve.points, (Points{{0.0, 0.0}, {10.0, 0.0}, {10.0, 10.0}}));
    const Curve square = fit(Points{{5, 0}, {10, 0}, {10, 10}, {0, 10}, {0, 0}, {5, 0}}, true, tolerance);
    EXPECT_EQ(square.points, (Points{{10, 0}, {10, 10}, {0, 10}, {0, 0}, {10, 0}}));
    EXPECT_TRUE(square.closed);
}

TEST(Fit, OfALineThatGoesOverIntoAnArcIsALineAndAnArc) {
    Points line{{-100.0, -10.0}};
    for (const dvec2& p : circle(10.0, 60, -std::numbers::pi / 2.0, std::numbers::pi / 2.0)) line.push_back(p);
    line.push_back({-100.0, 10.0});
    const Curve curve = fit(line, false, tolerance);
    expect_fits(line, curve);
    EXPECT_LE(curve.points.size(), 9u);
    EXPECT_EQ(curve.cubic.front(), 0);
    EXPECT_EQ(curve.cubic.back(), 0);
}

TEST(Fit, OfAPolygonWithLongSidesIsThatPolygon) {
    const Points line = circle(50.0, 24);
    const Curve curve = fit(line, true, tolerance);
    expect_fits(line, curve);
    EXPECT_EQ(curve.points.size(), 25u);
}

TEST(Fit, OfLittleOrNothingHasNoNaN) {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    EXPECT_TRUE(fit({}, false, tolerance).empty());
    EXPECT_TRUE(fit(Points{{1, 1}}, false, tolerance).empty());
    EXPECT_TRUE(fit(Points{{1, 1}, {1, 1}, {1, 1}}, true, tolerance).empty());
    EXPECT_TRUE(fit(Points{{nan, 1}, {1, nan}}, false, tolerance).empty());
    EXPECT_EQ(fit(Points{{0, 0}, {nan, 1}, {1e-3, 0}}, false, tolerance).points, (Points{{0, 0}, {1e-3, 0}}));
    for (const Points& line : {circle(0.01, 30), circle(0.001, 5), Points{{0, 0}, {1, 0}, {0, 0}},
                               Points{{0, 0}, {1, 0}, {0.5, 0}, {2, 0}, {0, 0}}})
        for (const bool closed : {false, true}) {
            const Curve curve = fit(line, closed, tolerance);
            for (const dvec2& p : curve.points) EXPECT_TRUE(std::isfinite(p.x) && std::isfinite(p.y));
            EXPECT_LE(error(line, curve), tolerance + 1e-5);
        }
}

TEST(Fit, KeepsTheBoundOnRandomPolylinesAndIsTheSameTwice) {
    std::mt19937 random(5);
    std::normal_distribution<double> normal;
    for (int k = 0; k < 300; ++k) {
        // From smooth waves to noise, of steps from far below the tolerance to far above it.
        const double step = std::exp(2.0 * normal(random) - 2.0), turn = 0.3 * std::exp(normal(random));
        dvec2 at(0.0);
        double angle = 0.0, rate = 0.0;
        Points line{at};
        for (int i = 0; i < 200; ++i) {
            rate = 0.8 * rate + turn * normal(random) * (k % 3 == 0 ? 1.0 : 0.1);
            angle += rate;
            at += step * (k % 2 ? std::exp(normal(random)) : 1.0) * dvec2(std::cos(angle), std::sin(angle));
            line.push_back(at);
        }
        const Curve curve = fit(line, false, tolerance);
        expect_fits(line, curve);
        EXPECT_EQ(curve.points, fit(line, false, tolerance).points);
    }
}

TEST(Fit, OfASmoothWaveHasATenthOfItsNumbers) {
    Points line;
    for (int i = 0; i <= 1000; ++i) line.push_back({0.1 * i, 5.0 * std::sin(0.02 * i)});
    const Curve curve = fit(line, false, tolerance);
    expect_fits(line, curve);
    EXPECT_LE(curve.points.size() * 10, line.size());
}

TEST(Fit, HasNoMoreNumbersThanLinesWithinTheBound) {
    // Coarse waves, of which lines leave out a few points and cubics reach over a few sides.
    for (const double step : {0.5, 1.0, 2.0}) {
        Points line;
        for (int i = 0; i < 300; ++i) line.push_back({step * i, 0.3 * std::sin(0.25 * i) + 0.02 * std::sin(2.0 * i)});
        std::size_t lines = 1, from = 0;
        for (std::size_t to = 2; to < line.size(); ++to)
            for (std::size_t i = from + 1; i < to; ++i)
                if (distance_to_segment(line[i], line[from], line[to]) > 0.9 * tolerance) {
                    ++lines;
                    from = to - 1;
                    break;
                }
        const Curve curve = fit(line, false, tolerance);
        expect_fits(line, curve);
        EXPECT_LE(curve.points.size() - 1, lines);
    }
}

TEST(Fit, OfALongSpiralHasACubicForEachPartOfATurn) {
    // Each cubic is found by trying points near it, not all that come after it.
    Points line;
    for (int i = 0; i <= 200'000; ++i) {
        const double angle = 0.01 * i;
        line.push_back((10.0 + 0.5 * angle) * dvec2(std::cos(angle), std::sin(angle)));
    }
    const Curve curve = fit(line, false, tolerance);
    EXPECT_EQ(curve.start(), line.front());
    EXPECT_EQ(curve.end(), line.back());
    const double turns = 2000.0 / (2.0 * std::numbers::pi);
    EXPECT_GE(double(curve.cubic.size()), 3.0 * turns);
    EXPECT_LE(double(curve.cubic.size()), 12.0 * turns);
    const Points begin(line.begin(), line.begin() + 1000), flat = flattened(curve, 1e-4);
    for (const dvec2& p : begin) EXPECT_LE(distance(p, Points(flat.begin(), flat.begin() + 5000)), tolerance + 1e-3);
}

TEST(Fit, StepsOfACubicAreAtMostTenThousandHoweverSmallTheErrorIs) {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    const Cubic wide{dvec2(0.0), dvec2(1e150), dvec2(-1e150), dvec2(0.0)};
    EXPECT_EQ(steps_of(wide, 1e-300), 10000);
    EXPECT_EQ(steps_of(wide, 0.0), 10000);
    EXPECT_EQ(steps_of(Cubic{dvec2(nan), dvec2(1.0), dvec2(2.0), dvec2(3.0)}, 0.01), 1);
}

TEST(Fit, OfToleranceZeroIsThePolyline) {
    const Points line = circle(1.0, 12);
    EXPECT_EQ(fit(line, true, 0.0).points, line);
}
