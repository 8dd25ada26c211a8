// SPDX-License-Identifier: GPL-3.0-or-later
// What a plotter draws: each line once, joined, in an order of short ways.
#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <random>

#include <fovea/base/cancel.h>
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

/// Counts polls, and asks for cancellation at the `last` one.
struct Counting : Cancel {
    explicit Counting(std::size_t until) : last(until) {}
    bool asked() const override { return ++polls >= last; }

    const std::size_t last;
    mutable std::size_t polls = 0;
};

/// Lines from one vertex in all directions.
std::vector<Line> fan(std::size_t count) {
    std::vector<Line> lines;
    for (std::size_t i = 0; i < count; ++i) {
        const double angle = 6.283185307179586 * double(i) / double(count);
        lines.push_back({{{0, 0}, {100.0 * std::cos(angle), 100.0 * std::sin(angle)}}, false, i});
    }
    return lines;
}

bool equal(const std::vector<Turn>& one, const std::vector<Turn>& other) {
    return std::ranges::equal(
        one, other, [](const Turn& a, const Turn& b) { return a.stroke == b.stroke && a.reversed == b.reversed; });
}

void expect_each_once(const std::vector<Turn>& plan, std::size_t count) {
    std::vector<std::size_t> drawn;
    for (const Turn& turn : plan) drawn.push_back(turn.stroke);
    std::ranges::sort(drawn);
    ASSERT_EQ(drawn.size(), count);
    for (std::size_t i = 0; i < count; ++i) EXPECT_EQ(drawn[i], i);
}

dvec2 end_of(In<Stop> strokes, const Turn& turn, bool last) {
    const Stop& stop = strokes[turn.stroke];
    return last != turn.reversed ? stop.end : stop.start;
}

/// The shortest way over all of a few strokes: of each set of them with each of them last, either way around. Held &
/// Karp, 1962.
double least_way(In<Stop> strokes, const dvec2& home) {
    const std::size_t count = strokes.size(), sets = std::size_t(1) << count;
    std::vector<double> least(sets * 2 * count, HUGE_VAL);
    double best = HUGE_VAL;
    for (std::size_t set = 1; set < sets; ++set)
        for (std::size_t last = 0; last < 2 * count; ++last) {
            const Turn turn{last / 2, last % 2 == 1};
            const std::size_t before = set & ~(std::size_t(1) << turn.stroke);
            if (before == set) continue;
            const dvec2 start = end_of(strokes, turn, false);
            double& way = least[set * 2 * count + last];
            if (before == 0) way = glm::distance(home, start);
            for (std::size_t k = 0; k < 2 * count; ++k)
                way = std::min(way, least[before * 2 * count + k] +
                                        glm::distance(end_of(strokes, {k / 2, k % 2 == 1}, true), start));
            if (set + 1 == sets) best = std::min(best, way);
        }
    return best;
}

/// Turns parts of a plan around as long as any turn makes it shorter: 2-opt, in full.
void turn_all(In<Stop> strokes, std::vector<Turn>& plan, const dvec2& home) {
    const auto last = [&](std::size_t i) { return i == 0 ? home : end_of(strokes, plan[i - 1], true); };
    for (bool any = true; any;) {
        any = false;
        for (std::size_t i = 0; i < plan.size(); ++i)
            for (std::size_t j = i + 1; j <= plan.size(); ++j) {
                const dvec2 before = last(i), first = end_of(strokes, plan[i], false), end = last(j);
                const auto after = [&](const dvec2& from) {
                    return j < plan.size() ? glm::distance(from, end_of(strokes, plan[j], false)) : 0.0;
                };
                if (glm::distance(before, end) + after(first) > glm::distance(before, first) + after(end) - 1e-9)
                    continue;
                std::reverse(plan.begin() + std::ptrdiff_t(i), plan.begin() + std::ptrdiff_t(j));
                for (std::size_t k = i; k < j; ++k) plan[k].reversed = !plan[k].reversed;
                any = true;
            }
    }
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

TEST(JoinLines, DashesOfOneStrokeAreNotJoinedAndThoseOfTwoAre) {
    const auto dashes = [](Index first, Index second) {
        return joined({{{{0, 0}, {1, 0}}, false, 0, first}, {{{1.04, 0}, {2, 0}}, false, 1, second}}, 0.05).size();
    };
    EXPECT_EQ(dashes(7, 7), 2u);
    EXPECT_EQ(dashes(7, 8), 1u);
    EXPECT_EQ(dashes(none, none), 1u);
    const std::vector<Line> left =
        without_doubles({{{{0, 0}, {9, 0}}, false, 0, none}, {{{5, 0}, {13, 0}}, false, 1, 7}}, 0.05, 0.2);
    ASSERT_EQ(left.size(), 2u);
    EXPECT_EQ(left[1].dash_of, 7u);
}

TEST(JoinLines, OfAFanAreThoseOppositeEachOther) {
    const std::vector<Line> lines = joined(fan(600), 0.01);
    EXPECT_EQ(lines.size(), 300u);
    for (const Line& line : lines) EXPECT_NEAR(glm::distance(line.points.front(), line.points.back()), 200.0, 1e-6);
}

TEST(JoinLines, PollsForEachLine) {
    const Counting all(std::size_t(-1));
    {
        const Cancelling scope(&all);
        joined(without_doubles(fan(200), 0.01, 0.2), 0.01);
    }
    EXPECT_GE(all.polls, 600u);
    const Counting some(300);
    const Cancelling scope(&some);
    EXPECT_THROW(joined(without_doubles(fan(200), 0.01, 0.2), 0.01), Cancelled);
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
        EXPECT_TRUE(equal(plan, again));
    }
}

TEST(PlotOrder, OfFewStrokesIsNextToTheBest) {
    double sum = 0.0, best = 0.0;
    for (unsigned seed = 0; seed < 20; ++seed) {
        const std::vector<Stop> strokes = random_strokes(9, seed);
        const double way = way_between(strokes, plot_order(strokes, {0, 0}), {0, 0}),
                     least = least_way(strokes, {0, 0});
        EXPECT_LE(way, 1.3 * least);
        EXPECT_GE(way, least - 1e-9);
        sum += way;
        best += least;
    }
    EXPECT_LE(sum, 1.05 * best);
}

TEST(PlotOrder, IsNoLongerThanTheNearestEndsImprovedByAllTurns) {
    for (const unsigned seed : {1u, 2u, 3u}) {
        const std::vector<Stop> strokes = random_strokes(400, seed);
        std::vector<Turn> plan = nearest_order(strokes, {0, 0});
        turn_all(strokes, plan, {0, 0});
        const double way = way_between(strokes, plot_order(strokes, {0, 0}), {0, 0});
        EXPECT_LE(way, 1.1 * way_between(strokes, plan, {0, 0}));
        std::vector<Turn> unordered;
        for (std::size_t i = 0; i < strokes.size(); ++i) unordered.push_back({i, false});
        EXPECT_LE(way, 0.4 * way_between(strokes, unordered, {0, 0}));
    }
}

TEST(PlotOrder, OfStrokesAtOnePlaceIsAnyOrder) {
    const std::vector<Stop> same(50, Stop{{3, 3}, {3, 3}});
    expect_each_once(plot_order(same, {0, 0}), 50);
}

TEST(PlotOrder, EndsAfterItsTrialsWithAWayThatIsNoLonger) {
    const std::vector<Stop> strokes = random_strokes(3000, 3);
    const std::vector<Turn> nearest = nearest_order(strokes, {0, 0});
    EXPECT_TRUE(equal(plot_order(strokes, {0, 0}, 0), nearest));
    double way = way_between(strokes, nearest, {0, 0});
    for (const std::size_t trials : {10'000u, 1'000'000u, 100'000'000u}) {
        const double shorter = way_between(strokes, plot_order(strokes, {0, 0}, trials), {0, 0});
        EXPECT_LT(shorter, way);
        way = shorter;
    }
}

TEST(PlotOrder, OfVeryManyStrokesTakesBoundedTrialsAndHearsACancel) {
    const std::vector<Stop> strokes = random_strokes(50'000, 1);
    const Counting all(std::size_t(-1));
    {
        const Cancelling scope(&all);
        const std::vector<Turn> plan = plot_order(strokes, {0, 0}, 20'000'000);
        EXPECT_LT(way_between(strokes, plan, {0, 0}),
                  0.98 * way_between(strokes, nearest_order(strokes, {0, 0}), {0, 0}));
    }
    EXPECT_LT(all.polls, 2'000'000u);
    const Counting some(120'000);
    const Cancelling scope(&some);
    EXPECT_THROW(plot_order(strokes, {0, 0}), Cancelled);
}
