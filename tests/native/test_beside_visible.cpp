// SPDX-License-Identifier: GPL-3.0-or-later
// Hidden lines that coincide with visible ones are left out, and only those.
#include <gtest/gtest.h>
#include <random>
#include <tbb/global_control.h>

#include <fovea/runs/filters.h>

#include "stroke_fixture.h"

namespace fovea {
using namespace draw;
namespace {

using namespace stroke_fixture;

/// Straight lines, the first visible and the others hidden.
struct Lines {
    ClippedPaths clipped;
    Runs runs;

    explicit Lines(const std::vector<std::vector<vec2>>& lines) {
        for (const auto& line : lines) add_piece(clipped, line);
        runs = whole_runs(clipped);
        for (std::size_t r = 1; r < runs.size(); ++r) runs.invisibility[r] = 2;
    }

    /// Pixels that are left of a line.
    double left(Index piece, double near_px = 4.0) const {
        const Runs kept = without_beside_visible(clipped, runs, near_px);
        double sum = 0.0;
        for (std::size_t r = 0; r < kept.size(); ++r)
            if (kept.piece[r] == piece) sum += kept.end_px[r] - kept.start_px[r];
        return sum;
    }
};

TEST(BesideVisible, WhatGoesAlongAVisibleLineIsLeftOut) {
    for (float apart : {0.0f, 1.5f, 3.5f}) {
        const Lines lines(
            {{{10, 50}, {210, 50}}, {{10, 50 + apart}, {210, 50 + apart}}, {{210, 50 - apart}, {10, 50 - apart}}});
        EXPECT_EQ(lines.left(0), 200.0);
        EXPECT_EQ(lines.left(1), 0.0) << apart;
        EXPECT_EQ(lines.left(2), 0.0) << "the other way round";
    }
}

TEST(BesideVisible, WhatIsFartherStays) {
    EXPECT_NEAR(Lines({{{10, 50}, {210, 50}}, {{10, 55}, {210, 55}}}).left(1), 200.0, 1e-9);
    EXPECT_NEAR(Lines({{{10, 50}, {210, 50}}, {{10, 53}, {210, 53}}}).left(1, 2.0), 200.0, 1e-9);
}

TEST(BesideVisible, OnlyThePartBesideIsCut) {
    const Lines lines({{{10, 50}, {110, 50}}, {{60, 50}, {210, 50}}});
    EXPECT_NEAR(lines.left(1), 100.0, 5.0);
    const Runs kept = without_beside_visible(lines.clipped, lines.runs, 4.0);
    ASSERT_EQ(kept.size(), 2u);
    EXPECT_EQ(kept.invisibility[1], 2);
    EXPECT_NEAR(kept.end_px[1], 75.0, 1e-9) << "its far end stays";
}

TEST(BesideVisible, LinesThatCrossStayWhole) {
    for (int degrees : {15, 30, 60, 90, 165}) {
        const float a = float(degrees * 3.14159265 / 180.0);
        const vec2 way(100.0f * std::cos(a), 100.0f * std::sin(a)), center(110, 50);
        EXPECT_NEAR(Lines({{{10, 50}, {210, 50}}, {center - way, center + way}}).left(1), 200.0, 1e-3) << degrees;
    }
}

TEST(BesideVisible, ALineThatGoesOnHiddenFromWhereItWasVisibleStays) {
    Lines lines({{{10, 50}, {210, 50}}});
    lines.runs = Runs();
    lines.runs.push(0, -100.0, 0.0, 0);
    lines.runs.push(0, 0.0, 100.0, 1);
    EXPECT_NEAR(lines.left(0), 200.0, 1e-9);
}

TEST(BesideVisible, WithoutVisibleLinesAllStays) {
    Lines lines({{{10, 50}, {210, 50}}, {{10, 50}, {210, 50}}});
    lines.runs.invisibility[0] = 1;
    EXPECT_NEAR(lines.left(0) + lines.left(1), 400.0, 1e-9);
    EXPECT_EQ(without_beside_visible({}, {}, 4.0).size(), 0u);
    EXPECT_THROW(without_beside_visible({}, {}, 0.0), std::invalid_argument);
}

TEST(BesideVisible, SameForAnyNumberOfThreads) {
    std::mt19937 random(11);
    std::uniform_real_distribution<float> at(0.0f, 600.0f);
    std::vector<std::vector<vec2>> drawn;
    for (int i = 0; i < 3000; ++i) drawn.push_back({{at(random), at(random)}, {at(random), at(random)}});
    Lines lines(drawn);
    for (std::size_t r = 0; r < lines.runs.size(); ++r) lines.runs.invisibility[r] = r % 3 ? 1 : 0;
    const Runs many = without_beside_visible(lines.clipped, lines.runs, 4.0);
    tbb::global_control one(tbb::global_control::max_allowed_parallelism, 1);
    const Runs single = without_beside_visible(lines.clipped, lines.runs, 4.0);
    EXPECT_EQ(many.piece, single.piece);
    EXPECT_EQ(many.start_px, single.start_px);
    EXPECT_EQ(many.end_px, single.end_px);
    EXPECT_NE(many.end_px, lines.runs.end_px);
}

}  // namespace
}  // namespace fovea
