// SPDX-License-Identifier: GPL-3.0-or-later
// What a plotter draws: each line once, joined, in an order of short ways.
#include <algorithm>
#include <gtest/gtest.h>
#include <random>

#include <fovea/vector/join_lines.h>
#include <fovea/vector/plot_order.h>

using namespace fovea;
using namespace fovea::vector;

namespace {

double total(const std::vector<Line>& lines) {
    double sum = 0.0;
    for (const Line& line : lines) sum += length_of(line.points);
    return sum;
}

std::vector<Stop> random_strokes(std::size_t count, unsigned seed) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> place(0.0, 200.0), step(-5.0, 5.0);
    std::vector<Stop> strokes;
    for (std::size_t i = 0; i < count; ++i) {
        const dvec2 start(place(random), place(random));
        strokes.push_back({start, start + dvec2(step(random), step(random))});
    }
    return strokes;
}

void expect_each_once(const std::vector<Turn>& plan, std::size_t count) {
    std::vector<std::size_t> drawn;
    for (const Turn& turn : plan) drawn.push_back(turn.stroke);
    std::ranges::sort(drawn);
    ASSERT_EQ(drawn.size(), count);
    for (std::size_t i = 0; i < count; ++i) EXPECT_EQ(drawn[i], i);
}

}  // namespace

TEST(JoinLines, SidesOfASquareBecomeOneClosedLine) {
    const std::vector<Line> square =
        joined({{{{0, 0}, {1, 0}}}, {{{1, 1}, {1, 0}}}, {{{1, 1}, {0, 1}}}, {{{0, 0}, {0, 1}}}}, 0.01);
    ASSERT_EQ(square.size(), 1u);
    EXPECT_TRUE(square[0].closed);
    EXPECT_EQ(square[0].points.size(), 5u);
    EXPECT_EQ(square[0].points.front(), square[0].points.back());
}

TEST(JoinLines, WhereFourLinesMeetThoseThatGoOnStraightAreJoined) {
    const std::vector<Line> cross = joined({{{{-1, 0}, {0, 0}}, false, 0},
                                            {{{0, 0}, {0, 1}}, false, 1},
                                            {{{0, 0}, {1, 0}}, false, 2},
                                            {{{0, -1}, {0, 0}}, false, 3}},
                                           0.01);
    ASSERT_EQ(cross.size(), 2u);
    EXPECT_EQ(cross[0].points, (Points{{-1, 0}, {0, 0}, {1, 0}}));
    EXPECT_EQ(cross[1].points, (Points{{0, 1}, {0, 0}, {0, -1}}));
}

TEST(JoinLines, EndsThatAreApartAreNotJoined) {
    EXPECT_EQ(joined({{{{0, 0}, {1, 0}}}, {{{1.1, 0}, {2, 0}}}}, 0.05).size(), 2u);
    EXPECT_EQ(joined({}, 0.05).size(), 0u);
}

TEST(JoinLines, WhatIsThereAlreadyIsLeftOut) {
    // The same line again, the other way around and a bit beside; a part of it that goes on; and one across.
    const std::vector<Line> left = without_doubles({{{{0, 0}, {10, 0}}, false, 0},
                                                    {{{10, 0.01}, {0, 0.01}}, false, 1},
                                                    {{{8, 0}, {13, 0}}, false, 2},
                                                    {{{5, -1}, {5, 1}}, false, 3}},
                                                   0.05, 0.2);
    EXPECT_NEAR(total(left), 10.0 + 3.0 + 2.0, 0.6);
    ASSERT_EQ(left.size(), 3u);
    EXPECT_EQ(left[0].points, (Points{{0, 0}, {10, 0}}));
    EXPECT_EQ(left[2].points, (Points{{5, -1}, {5, 1}}));
    EXPECT_EQ(without_doubles(left, 0.05, 0.2).size(), 3u);
}

TEST(PlotOrder, OfStrokesInARowIsThatRow) {
    const std::vector<Stop> row{{{6, 0}, {7, 0}}, {{1, 0}, {0, 0}}, {{4, 0}, {3, 0}}};
    const std::vector<Turn> plan = plot_order(row, {0, 0});
    EXPECT_DOUBLE_EQ(way_between(row, plan, {0, 0}), 4.0);
    EXPECT_EQ(plan[0].stroke, 1u);
    EXPECT_TRUE(plan[0].reversed);
    EXPECT_TRUE(plot_order({}, {0, 0}).empty());
}

TEST(PlotOrder, HasEachStrokeOnceAndLessWayThanToTheNearestEnd) {
    for (const std::size_t count : {1u, 2u, 7u, 300u, 2000u}) {
        const std::vector<Stop> strokes = random_strokes(count, unsigned(count));
        const std::vector<Turn> plan = plot_order(strokes, {0, 200}), nearest = nearest_order(strokes, {0, 200});
        expect_each_once(plan, count);
        expect_each_once(nearest, count);
        const double way = way_between(strokes, plan, {0, 200});
        EXPECT_LE(way, way_between(strokes, nearest, {0, 200}) + 1e-9);
        if (count < 300) continue;
        EXPECT_LT(way, 0.9 * way_between(strokes, nearest, {0, 200}));
        const std::vector<Turn> again = plot_order(strokes, {0, 200});
        EXPECT_TRUE(std::ranges::equal(plan, again, [](const Turn& a, const Turn& b) {
            return a.stroke == b.stroke && a.reversed == b.reversed;
        }));
    }
}

TEST(PlotOrder, OfStrokesAtOnePlaceIsAnyOrder) {
    const std::vector<Stop> same(50, Stop{{3, 3}, {3, 3}});
    expect_each_once(plot_order(same, {0, 0}), 50);
}
