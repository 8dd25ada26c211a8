// SPDX-License-Identifier: GPL-3.0-or-later
// Wobble and pressure: how far, where not, and that they stay where they are.
#include <gtest/gtest.h>

#include <fovea/stroke/hand.h>

namespace fovea {
using namespace draw;
namespace {

CenterLine straight(double from, double to) { return {{{from, 10.0}, from, 2.0f}, {{to, 10.0}, to, 2.0f}}; }

TEST(Wobble, StraysAsFarAsToldAndNoFarther) {
    CenterLine line = straight(-300, 300);
    wobble(line, 5.0, 40.0, 7);
    double most = 0.0;
    for (const CenterPoint& p : line) most = std::max(most, std::abs(p.px.y - 10.0));
    EXPECT_LE(most, 5.0);
    EXPECT_GT(most, 1.5);
}

TEST(Wobble, EndsStay) {
    CenterLine line = straight(-30, 170);
    wobble(line, 5.0, 40.0, 3);
    EXPECT_EQ(line.front().px, dvec2(-30, 10));
    EXPECT_EQ(line.back().px, dvec2(170, 10));
}

TEST(Wobble, BelongsToThePathAndNotToWhatIsSeenOfIt) {
    CenterLine whole = straight(-400, 400), part = straight(-100, 250);
    wobble(whole, 4.0, 30.0, 11);
    wobble(part, 4.0, 30.0, 11);
    int same = 0;
    for (const CenterPoint& p : part)
        for (const CenterPoint& q : whole)
            if (std::abs(p.arc - q.arc) < 1e-9 && p.arc > -60 && p.arc < 210) {
                EXPECT_NEAR(p.px.y, q.px.y, 1e-6);
                ++same;
            }
    EXPECT_GT(same, 40);
}

TEST(Wobble, OtherSeedsAreOtherHands) {
    CenterLine a = straight(-200, 200), b = a, still = a;
    wobble(a, 4.0, 30.0, 1);
    wobble(b, 4.0, 30.0, 2);
    wobble(still, 0.0, 30.0, 1);
    ASSERT_EQ(a.size(), b.size());
    double apart = 0.0;
    for (std::size_t i = 0; i < a.size(); ++i) apart = std::max(apart, glm::distance(a[i].px, b[i].px));
    EXPECT_GT(apart, 1.0);
    EXPECT_EQ(still.size(), 2u);
}

/// A line as a drawing of a boil has it.
CenterLine boiled(double amount, int drawing) {
    CenterLine line = straight(-200, 200);
    wobble(line, 4.0, 30.0, Hand(5, amount, drawing));
    return line;
}

double largest_change(const CenterLine& a, const CenterLine& b) {
    double largest = 0.0;
    for (std::size_t i = 0; i < a.size(); ++i) largest = std::max(largest, glm::distance(a[i].px, b[i].px));
    return largest;
}

TEST(Boil, TheFirstDrawingIsAsWithoutItAndEachOtherOneIsItsOwn) {
    CenterLine still = straight(-200, 200);
    wobble(still, 4.0, 30.0, 5);
    EXPECT_EQ(largest_change(boiled(1.0, 0), still), 0.0);
    EXPECT_EQ(largest_change(boiled(1.0, 2), boiled(1.0, 2)), 0.0);
    for (int k = 0; k < 4; ++k)
        for (int other = 0; other < k; ++other) EXPECT_GT(largest_change(boiled(1.0, k), boiled(1.0, other)), 1.0);
}

TEST(Boil, StraysByItsAmountAndNoFartherThanTheWobble) {
    const CenterLine still = boiled(0.0, 1);
    double before = 0.0;
    for (const double amount : {0.1, 0.3, 0.6}) {
        const CenterLine line = boiled(amount, 1);
        const double change = largest_change(line, still);
        EXPECT_GT(change, before) << amount;
        before = change;
        for (const CenterPoint& p : line) EXPECT_LE(std::abs(p.px.y - 10.0), 4.0);
    }
    EXPECT_EQ(boiled(1.0, 1).front().px, still.front().px) << "ends stay";
    EXPECT_EQ(boiled(1.0, 1).back().px, still.back().px);
}

TEST(Pressure, ThinsEndsAndLeavesTheMiddle) {
    CenterLine line = straight(-100, 100);
    press(line, 1.0f);
    for (const CenterPoint& p : line) {
        const float width = 2.0f * p.half_width * p.opacity;  // thinner than a pixel is fainter
        EXPECT_LE(width, 4.0f);
        if (std::abs(p.arc) < 1.0) {
            EXPECT_NEAR(width, 4.0f, 1e-3f);
        }
    }
    EXPECT_NEAR(line.front().opacity, 0.0f, 1e-6f);
    CenterLine even = straight(-100, 100);
    press(even, 0.0f);
    EXPECT_EQ(even.size(), 2u);
}

}  // namespace
}  // namespace fovea
