// SPDX-License-Identifier: GPL-3.0-or-later
// How long each place of a line is seen while the ends of what is seen move.
#include <algorithm>
#include <cmath>
#include <functional>
#include <gtest/gtest.h>
#include <random>

#include <fovea/elision/seen_over_time.h>

using namespace fovea;
using namespace fovea::draw;

namespace {

constexpr double length = 100.0;

SeenAlong along(bool first, std::vector<double> changes) {
    SeenAlong made;
    made.first = first;
    made.changes = std::move(changes);
    return made;
}

float share_at(const std::vector<Ramp>& ramps, double place) {
    for (const Ramp& ramp : ramps)
        if (place <= ramp.to)
            return glm::mix(ramp.at_from, ramp.at_to, float((place - ramp.from) / (ramp.to - ramp.from)));
    return -1.0f;
}

/// Moments -frames .. frames.
std::vector<SeenAlong> moments(int frames, const std::function<SeenAlong(double)>& at) {
    std::vector<SeenAlong> found;
    for (int k = -frames; k <= frames; ++k) found.push_back(at(k));
    return found;
}

/// Share of the time from -frames to frames for which a place is seen, by many moments of it.
double expected(int frames, const std::function<SeenAlong(double)>& at, double place) {
    constexpr int steps = 4000;
    int seen = 0;
    for (int i = 0; i < steps; ++i) seen += at(frames * (2.0 * (i + 0.5) / steps - 1.0)).at(place);
    return double(seen) / steps;
}

void expect_exact(int frames, const std::function<SeenAlong(double)>& at) {
    const auto ramps = seen_over_time(moments(frames, at), length);
    ASSERT_FALSE(ramps.empty());
    EXPECT_EQ(ramps.front().from, 0.0);
    EXPECT_EQ(ramps.back().to, length);
    for (double place = 0.05; place < length; place += 0.37)
        EXPECT_NEAR(share_at(ramps, place), expected(frames, at, place), 1e-3) << place;
}

}  // namespace

TEST(SeenOverTime, AnEndThatMovesSteadilyMakesARamp) {
    for (const int frames : {1, 2, 5})
        for (const double speed : {0.5, 3.0, -7.0}) {
            expect_exact(frames, [&](double time) { return along(true, {50 + speed * time}); });
            expect_exact(frames, [&](double time) { return along(false, {50 + speed * time}); });
        }
    const auto ramps = seen_over_time(moments(2, [](double time) { return along(true, {50 + 5 * time}); }), length);
    for (const double place : {20.0, 40.0, 45.0, 50.0, 57.0, 60.0, 80.0})
        EXPECT_NEAR(share_at(ramps, place), std::clamp((60.0 - place) / 20.0, 0.0, 1.0), 1e-6) << place;
}

TEST(SeenOverTime, ABarThatPassesMakesATrapezoidAlsoWhereItJumpsFartherThanItIsWide) {
    for (const double width : {1.0, 3.0, 8.0, 40.0})
        for (const double speed : {2.0, 6.0, -6.0})
            expect_exact(2, [&](double time) { return along(true, {50 + speed * time, 50 + speed * time + width}); });
}

TEST(SeenOverTime, ASlitThatMovesIsSeenForAPartOfTheTime) {
    expect_exact(3, [](double time) { return along(false, {40 + 5 * time, 42 + 5 * time}); });
}

TEST(SeenOverTime, WhatIsHiddenInOneFrameAloneStaysVisibleForTheRest) {
    for (const int frames : {1, 2, 4, 8})
        for (int of = -frames; of <= frames; ++of) {
            const auto ramps = seen_over_time(
                moments(frames, [&](double time) { return time == of ? along(true, {30, 60}) : along(true, {}); }),
                length);
            const double hidden = std::abs(of) == frames ? 0.25 / frames : 0.5 / frames;
            EXPECT_NEAR(share_at(ramps, 45), 1.0 - hidden, 1e-6) << frames << ' ' << of;
            EXPECT_GE(share_at(ramps, 45), float(frames) / float(frames + 1));
            EXPECT_EQ(share_at(ramps, 20), 1.0f);
            EXPECT_EQ(share_at(ramps, 80), 1.0f);
        }
}

TEST(SeenOverTime, ALineThatComesAtOnceChangesByAtMostOneFramesShare) {
    const int frames = 2;
    double before = 0.0;
    for (int at = -frames - 1; at <= frames + 1; ++at) {
        const auto now = moments(frames, [&](double time) { return along(at + time >= 0, {}); });
        const auto ramps = seen_over_time(now, length);
        const double share = ramps.empty() ? double(now[0].first) : share_at(ramps, 50);
        EXPECT_LE(share - before, 1.0 / (2 * frames) + 1e-6);
        EXPECT_GE(share, before);
        before = share;
    }
    EXPECT_EQ(before, 1.0);
}

TEST(SeenOverTime, WhereNothingChangesThereIsNothing) {
    EXPECT_TRUE(seen_over_time(moments(3, [](double) { return along(true, {}); }), length).empty());
    EXPECT_TRUE(seen_over_time(moments(3, [](double) { return along(false, {20, 30, 70}); }), length).empty());
    EXPECT_TRUE(
        seen_over_time(moments(3, [](double time) { return along(true, {50 + 1e-9 * time}); }), length).empty());
}

TEST(SeenOverTime, BackwardsItIsTheSame) {
    std::mt19937 random(5);
    std::uniform_real_distribution<double> any(1.0, 99.0);
    for (int k = 0; k < 200; ++k) {
        std::vector<SeenAlong> ahead = moments(2, [&](double) {
            std::vector<double> changes(random() % 5);
            for (double& change : changes) change = any(random);
            std::ranges::sort(changes);
            return along(random() % 2 != 0, changes);
        });
        const auto one = seen_over_time(ahead, length);
        std::ranges::reverse(ahead);
        const auto other = seen_over_time(ahead, length);
        for (double place = 0.5; place < length; place += 1.7) {
            EXPECT_NEAR(share_at(one, place), share_at(other, place), 1e-5);
            EXPECT_GE(share_at(one, place), 0.0f);
            EXPECT_LE(share_at(one, place), 1.0f + 1e-6f);
        }
    }
}
