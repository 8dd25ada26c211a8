// SPDX-License-Identifier: GPL-3.0-or-later
#include <bit>
#include <cmath>
#include <cstdint>
#include <gtest/gtest.h>
#include <random>
#include <tuple>
#include <vector>

#include <fovea/base/types.h>
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

/// Neighborhoods of so many points at random offsets, over planes that lie anyhow.
void scatter(std::mt19937& random, const std::vector<std::size_t>& counts, Heights& heights, Planes& planes) {
    std::normal_distribution<double> number;
    for (std::size_t lane = 0; lane < counts.size(); ++lane) {
        auto points = scattered(random, counts[lane]);
        if (!points.empty()) points[0] = {};
        fill(heights, lane, points);
        planes.nearest[lane] = counts[lane] / 2;
        const dvec3 n = glm::normalize(dvec3(number(random), number(random), number(random)));
        const dvec3 t = glm::normalize(glm::cross(n, dvec3(n.y, n.z, -n.x))), b = glm::cross(n, t);
        for (int i = 0; i < 3; ++i)
            std::tie(planes.axes[0][i][lane], planes.axes[1][i][lane], planes.axes[2][i][lane]) =
                std::tuple(t[i], b[i], n[i]);
    }
}

TEST(HeightFits, PointsOnPlanesKeepTheirDistancesInUnitsOfTheMean) {
    std::mt19937 random(4);
    for (const bool even : {false, true}) {
        Heights heights;
        Planes planes;
        scatter(random, {20, 7, 2, 30}, heights, planes);
        const Heights before = heights;
        put_on_planes(heights, planes, even, false);
        for (std::size_t lane = 0; lane < Heights::lanes; ++lane) {
            double sum = 0.0, nearest = 0.0;
            for (std::size_t i = 0; i < heights.counts[lane]; ++i) {
                const std::size_t at = i * Heights::lanes + lane;
                const double size = glm::length(dvec3(heights.x[at], heights.y[at], heights.z[at]));
                const double offset = glm::length(dvec3(before.x[at], before.y[at], before.z[at]));
                EXPECT_NEAR(size * planes.scale[lane], offset, 1e-12);
                EXPECT_NEAR(heights.weight[at], even ? 1.0 : 1.0 / (0.1 + size * size), 1e-12);
                const double height = before.x[at] * planes.axes[2][0][lane] + before.y[at] * planes.axes[2][1][lane] +
                                      before.z[at] * planes.axes[2][2][lane];
                EXPECT_NEAR(heights.z[at] * planes.scale[lane], height, 1e-12);
                sum += size;
                if (i <= planes.nearest[lane]) nearest += offset;
            }
            EXPECT_NEAR(sum / double(heights.counts[lane] - 1), 1.0, 1e-12);
            EXPECT_NEAR(planes.edge_length[lane], nearest / double(planes.nearest[lane]), 1e-12);
            for (std::size_t i = heights.counts[lane]; i < heights.weight.size() / Heights::lanes; ++i)
                EXPECT_EQ(heights.weight[i * Heights::lanes + lane], 0.0) << "where others have more points";
        }
    }
}

TEST(HeightFits, NeighborhoodsOfNoExtentHaveNoScaleAndNoPoints) {
    Heights heights;
    Planes planes;
    fill(heights, 0, {{}, {}, {}});
    fill(heights, 1, {{}});
    fill(heights, 2, {{}, {1.0, 0.0, 0.0, 0.0}});
    planes.axes[0][0][2] = 1.0;
    put_on_planes(heights, planes, false, false);
    EXPECT_EQ(planes.scale, (std::array<double, Heights::lanes>{0.0, 0.0, 1.0, 0.0}));
    EXPECT_EQ(heights.counts, (std::array<std::size_t, Heights::lanes>{0, 0, 2, 0}));
    for (const auto* values : {&heights.x, &heights.y, &heights.z, &heights.weight})
        for (const double value : *values) EXPECT_TRUE(std::isfinite(value));
}

TEST(HeightFits, PointsOnPlanesAreTheSameBitsInRegistersOfTwoAndOfFourNumbers) {
    if (!has_wide_registers()) GTEST_SKIP() << "this processor has no registers of four doubles";
    std::mt19937 random(5);
    for (int trial = 0; trial < 500; ++trial) {
        Heights narrow;
        Planes planes;
        scatter(random, {random() % 40, random() % 40, random() % 40, random() % 40}, narrow, planes);
        Heights wide = narrow;
        Planes of_wide = planes;
        put_on_planes(narrow, planes, trial % 2, false);
        put_on_planes(wide, of_wide, trial % 2, true);
        EXPECT_EQ(narrow.x, wide.x);
        EXPECT_EQ(narrow.y, wide.y);
        EXPECT_EQ(narrow.z, wide.z);
        EXPECT_EQ(narrow.weight, wide.weight);
        EXPECT_EQ(planes.scale, of_wide.scale);
        EXPECT_EQ(planes.edge_length, of_wide.edge_length);
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
