// SPDX-License-Identifier: GPL-3.0-or-later
// Transfer functions: what they are at their ends, between, and for what is no number.
#include <algorithm>
#include <gtest/gtest.h>
#include <limits>

#include <fovea/focus/transfer.h>

namespace fovea {
using namespace draw;
namespace {

TEST(Transfer, IsTheIdentityUnlessTold) {
    const Transfer identity;
    for (int i = -10; i <= 110; ++i) EXPECT_NEAR(identity(i / 100.0f), std::clamp(i / 100.0f, 0.0f, 1.0f), 1e-6f);
}

TEST(Transfer, RisesFromStartToEndAndStopsAtItsStrength) {
    const Transfer rise(0.2f, 0.6f, 0.5f, {});
    EXPECT_EQ(rise(0.1f), 0.0f);
    EXPECT_EQ(rise(0.2f), 0.0f);
    EXPECT_NEAR(rise(0.4f), 0.25f, 1e-6f);
    EXPECT_EQ(rise(0.6f), 0.5f);
    EXPECT_EQ(rise(7.0f), 0.5f);
}

TEST(Transfer, TurnsRoundWhereTheStartLiesBeyondTheEnd) {
    const Transfer up(0.2f, 0.6f, 0.8f, {}), down(0.6f, 0.2f, 0.8f, {});
    for (int i = 0; i <= 100; ++i) EXPECT_NEAR(up(i / 100.0f) + down(i / 100.0f), 0.8f, 1e-5f);
}

TEST(Transfer, IsAStepWhereStartAndEndAreEqual) {
    const Transfer step(0.5f, 0.5f, 1.0f, {});
    EXPECT_EQ(step(0.49f), 0.0f);
    EXPECT_EQ(step(0.5f), 1.0f);
}

TEST(Transfer, PassesThroughThePointsOfItsCurveAndNeverBeyondThem) {
    const vec2 points[] = {{0.0f, 0.0f}, {0.25f, 0.125f}, {0.5f, 0.75f}, {1.0f, 1.0f}};
    const Transfer curved(0.0f, 1.0f, 1.0f, points);
    for (const vec2& p : points) EXPECT_NEAR(curved(p.x), p.y, 1e-5f);
    float before = 0.0f;
    for (int i = 0; i <= 1000; ++i) {
        EXPECT_GE(curved(i / 1000.0f), before);
        before = curved(i / 1000.0f);
    }
    const vec2 bump[] = {{0.0f, 0.0f}, {0.4f, 1.0f}, {0.6f, 1.0f}, {1.0f, 0.2f}};
    const Transfer there_and_back(0.0f, 1.0f, 1.0f, bump);
    for (int i = 0; i <= 1000; ++i) EXPECT_LE(there_and_back(i / 1000.0f), 1.0f);
    EXPECT_NEAR(there_and_back(1.0f), 0.2f, 1e-6f);
}

TEST(Transfer, EmphasisMultipliesEffectsUpToTheirWholeAndDividesThoseTurnedRound) {
    const style::Transfer half{0.0, 1.0, 0.5, {}}, turned{1.0, 0.0, 0.5, {}};
    for (const float f : {0.0f, 0.1f, 0.4f, 1.0f}) {
        EXPECT_EQ(transfer_of(half, 1.0)(f), transfer_of(half)(f));
        EXPECT_FLOAT_EQ(transfer_of(half, 4.0)(f), std::min(1.0f, 2.0f * f));
        EXPECT_FLOAT_EQ(transfer_of(half, 0.5)(f), 0.25f * f);
        EXPECT_FLOAT_EQ(transfer_of(turned, 2.0)(f), 0.25f * (1.0f - f));
    }
}

TEST(Transfer, TakesWhatIsNoNumberForZero) {
    EXPECT_EQ(Transfer()(std::numeric_limits<float>::quiet_NaN()), 0.0f);
    EXPECT_EQ(Transfer()(std::numeric_limits<float>::infinity()), 1.0f);
}

TEST(Transfer, RefusesCurvesThatAreNone) {
    const vec2 back[] = {{0.5f, 0.0f}, {0.4f, 1.0f}}, outside[] = {{0.0f, 0.0f}, {1.0f, 1.5f}};
    EXPECT_THROW(Transfer(0.0f, 1.0f, 1.0f, back), std::invalid_argument);
    EXPECT_THROW(Transfer(0.0f, 1.0f, 1.0f, outside), std::invalid_argument);
    EXPECT_THROW(Transfer(0.0f, 1.0f, 1.5f, {}), std::invalid_argument);
    EXPECT_THROW(Transfer(0.0f, std::numeric_limits<float>::infinity(), 1.0f, {}), std::invalid_argument);
}

TEST(Transfer, CombinesSoThatNeitherCauseUndoesTheOther) {
    EXPECT_EQ(both(0.0f, 0.3f), 0.3f);
    EXPECT_EQ(both(1.0f, 0.3f), 1.0f);
    EXPECT_FLOAT_EQ(both(0.5f, 0.5f), 0.75f);
}

}  // namespace
}  // namespace fovea
