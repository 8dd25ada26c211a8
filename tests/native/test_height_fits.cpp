// SPDX-License-Identifier: GPL-3.0-or-later
#include <bit>
#include <cmath>
#include <cstdint>
#include <gtest/gtest.h>
#include <random>
#include <vector>

#include <fovea/field/height_fits.h>

namespace fovea::field {
namespace {

struct Point {
    double x, y, z, weight;
};

void fill(Heights& heights, std::size_t lane, const std::vector<Point>& points) {
    heights.add(lane, points.size());
    for (std::size_t i = 0; i < points.size(); ++i) {
        const std::size_t at = i * Heights::lanes + lane;
        heights.x[at] = points[i].x;
        heights.y[at] = points[i].y;
        heights.z[at] = points[i].z;
        heights.weight[at] = points[i].weight;
    }
}

std::vector<Point> scattered(std::mt19937& random, std::size_t count) {
    std::uniform_real_distribution<double> place(-2.0, 2.0), weight(0.1, 10.0);
    std::vector<Point> points;
    for (std::size_t i = 0; i < count; ++i)
        points.push_back({place(random), place(random), place(random), weight(random)});
    return points;
}

std::vector<std::uint64_t> bits(const Polynomial& found) {
    std::vector<std::uint64_t> result{std::uint64_t(found.degree)};
    for (const double a : found.a) result.push_back(std::bit_cast<std::uint64_t>(a));
    return result;
}

TEST(HeightFits, FindThePolynomialThatPointsLieOn) {
    std::mt19937 random(1);
    std::uniform_real_distribution<double> number(-1.0, 1.0);
    for (int degree = 2; degree <= max_degree; ++degree) {
        Heights heights;
        Polynomials wanted;
        for (std::size_t lane = 0; lane < Heights::lanes; ++lane) {
            for (int k = 0; k < terms(degree); ++k) wanted[lane].a[k] = number(random);
            auto points = scattered(random, 30 + lane);
            for (Point& p : points) p.z = height_of(wanted[lane], p.x, p.y);
            fill(heights, lane, points);
        }
        const auto found = fit_heights(degree, heights, false);
        for (std::size_t lane = 0; lane < Heights::lanes; ++lane) {
            EXPECT_EQ(found[lane].degree, degree);
            for (int k = 0; k < terms(max_degree); ++k) EXPECT_NEAR(found[lane].a[k], wanted[lane].a[k], 1e-9) << k;
        }
    }
}

TEST(HeightFits, AreTheSameBitsInRegistersOfTwoAndOfFourNumbers) {
    if (!has_wide_registers()) GTEST_SKIP() << "this processor has no registers of four doubles";
    std::mt19937 random(2);
    for (int trial = 0; trial < 2000; ++trial) {
        Heights heights;
        for (std::size_t lane = 0; lane < Heights::lanes; ++lane) fill(heights, lane, scattered(random, random() % 60));
        const auto narrow = fit_heights(4, heights, false), wide = fit_heights(4, heights, true);
        for (std::size_t lane = 0; lane < Heights::lanes; ++lane) ASSERT_EQ(bits(narrow[lane]), bits(wide[lane]));
    }
}

TEST(HeightFits, OfANeighborhoodDoNotDependOnTheOthers) {
    std::mt19937 random(3);
    for (int trial = 0; trial < 500; ++trial) {
        const auto points = scattered(random, random() % 40);
        Heights alone, together;
        fill(alone, 0, points);
        const std::size_t lane = trial % Heights::lanes;
        for (std::size_t k = 0; k < Heights::lanes; ++k)
            fill(together, k, k == lane ? points : scattered(random, random() % 80));
        const bool wide = has_wide_registers();
        ASSERT_EQ(bits(fit_heights(4, alone, wide)[0]), bits(fit_heights(4, together, wide)[lane])) << trial;
    }
}

TEST(HeightFits, AreOfTheHighestDegreeThatPointsDetermine) {
    std::mt19937 random(4);
    Heights heights;
    const std::size_t counts[] = {terms(4), terms(4) - 1, terms(2), terms(2) - 1};
    for (std::size_t lane = 0; lane < Heights::lanes; ++lane) fill(heights, lane, scattered(random, counts[lane]));
    const int wanted[] = {4, 3, 2, 0};
    for (std::size_t lane = 0; lane < Heights::lanes; ++lane)
        EXPECT_EQ(fit_heights(4, heights, false)[lane].degree, wanted[lane]);
    auto on_a_line = scattered(random, 40), on_a_circle = on_a_line;
    for (Point& p : on_a_line) p.y = 2.0 * p.x + 1.0;
    for (Point& p : on_a_circle) {
        const double r = std::hypot(p.x, p.y);
        p.x /= r;
        p.y /= r;
    }
    heights.clear();
    fill(heights, 0, on_a_line);
    fill(heights, 1, on_a_circle);
    const auto found = fit_heights(4, heights, false);
    EXPECT_EQ(found[0].degree, 0);
    EXPECT_EQ(found[1].degree, 0);
    EXPECT_EQ(bits(found[2]), bits(Polynomial{}));
}

}  // namespace
}  // namespace fovea::field
