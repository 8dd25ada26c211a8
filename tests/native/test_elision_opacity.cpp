// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <gtest/gtest.h>
#include <random>

#include "elision_fixture.h"

using namespace fovea;
using namespace fovea::draw;

namespace {

/// One straight run of so many samples, 2 px apart.
struct Row {
    Sheet sheet;
    OwnBands own;

    explicit Row(int samples) {
        sheet.line({{10.0f, 50.0f}, {10.0f + 2.0f * float(samples), 50.0f}});
        own = sheet.own();
    }
    Array<float> opacities(const std::vector<float>& scores, const ElisionOptions& options = {}) const {
        return elision_opacities(sheet.clipped, own, scores, options);
    }
};

std::vector<float> filled(std::size_t count, float value) { return std::vector<float>(count, value); }

}  // namespace

TEST(ElisionOpacity, FallsInALineFromAWholeBandToTheShareWhereLinesFade) {
    const Row row(40);
    for (const float from : {0.0f, 0.35f, 0.6f})
        for (const float score : {0.0f, 0.2f, 0.35f, 0.5f, 0.8f, 1.0f}) {
            const float wanted = std::clamp((score - from) / (1.0f - from), 0.0f, 1.0f);
            for (const float opacity : row.opacities(filled(40, score), {.fade_from = from}))
                EXPECT_FLOAT_EQ(opacity, wanted);
        }
}

TEST(ElisionOpacity, LeftoversGoAndLongPartsStay) {
    const Row row(60);
    for (int length = 1; length <= 20; ++length) {
        std::vector<float> scores = filled(60, 0.0f);
        std::fill_n(scores.begin() + 20, length, 1.0f);
        const Array<float> left = row.opacities(scores, {.stub_px = 12.0});
        EXPECT_EQ(std::ranges::count(left, 1.0f), length >= 6 ? length : 0) << length;
        std::ranges::rotate(scores, scores.begin() + 20);  // at the run's start: a stub where it meets another
        const Array<float> at_end = row.opacities(scores, {.stub_px = 12.0});
        EXPECT_EQ(std::ranges::count(at_end, 1.0f), length >= 6 ? length : 0) << length;
    }
}

TEST(ElisionOpacity, WhatIsALeftoverChangesSteadily) {
    // A run seen from a little nearer has its samples a little farther apart.
    const Row row(60);
    std::vector<float> scores = filled(60, 0.0f);
    std::fill_n(scores.begin() + 20, 6, 1.0f);
    float before = 1.0f;
    for (double stub_px = 12.0; stub_px <= 14.0; stub_px += 0.1) {
        const float left = row.opacities(scores, {.stub_px = stub_px})[22];
        EXPECT_NEAR(left, 1.0 - (stub_px - 12.0) / 2.0, 1e-3) << stub_px;
        EXPECT_LE(left, before + 1e-6f);
        before = left;
    }
}

TEST(ElisionOpacity, ShortRunsAndGapsStay) {
    const Row run(3);
    EXPECT_EQ(std::ranges::count(run.opacities(filled(3, 1.0f)), 1.0f), 3);
    const Row row(60);
    std::vector<float> scores = filled(60, 1.0f);
    scores[30] = 0.0f;
    const Array<float> left = row.opacities(scores);
    EXPECT_EQ(std::ranges::count(left, 1.0f), 59);
    EXPECT_EQ(left[30], 0.0f);
}

TEST(ElisionOpacity, NeverMoreThanWithoutTheOpeningAndAsContinuous) {
    const Row row(80);
    std::mt19937 random(2);
    std::uniform_real_distribution<float> any(0.0f, 1.0f), little(-0.01f, 0.01f);
    for (int k = 0; k < 50; ++k) {
        std::vector<float> scores, near;
        for (int s = 0; s < 80; ++s) {
            scores.push_back(any(random));
            near.push_back(std::clamp(scores.back() + little(random), 0.0f, 1.0f));
        }
        const Array<float> open = row.opacities(scores), close_by = row.opacities(near);
        const Array<float> plain = row.opacities(scores, {.stub_px = 0.0});
        for (int s = 0; s < 80; ++s) {
            EXPECT_LE(open[s], plain[s]);
            EXPECT_LE(std::abs(open[s] - close_by[s]), 0.01f / 0.65f + 1e-6f);
        }
    }
}

TEST(ElisionOpacity, CutLeavesNothingFaint) {
    const Row row(60);
    std::vector<float> scores;
    for (int s = 0; s < 60; ++s) scores.push_back(float(s) / 59.0f);
    const Array<float> faint = row.opacities(scores), cut = row.opacities(scores, {.cut = 0.5f});
    for (int s = 0; s < 60; ++s) EXPECT_EQ(cut[s], faint[s] >= 0.5f ? faint[s] : 0.0f);
}

TEST(ElisionOpacity, RunsAreSmoothedEachForItself) {
    Sheet sheet;
    sheet.line({{10.0f, 50.0f}, {110.0f, 50.0f}});
    sheet.runs = Runs();
    sheet.runs.push(0, 0.0, 50.0);
    sheet.runs.push(0, 50.0, 100.0, 1);
    const OwnBands own = sheet.own();
    Array<vec2> sums(50);
    for (int s = 0; s < 50; ++s) sums[s] = {s < 25 ? 0.0f : 10.0f, 10.0f};
    const Array<float> scores = elision_scores(own, sums);
    for (int s = 0; s < 50; ++s) EXPECT_EQ(scores[s], s < 25 ? 1.0f : 0.0f) << s;
    // Within a run over 9 samples, counted by the pixels that each has.
    for (int s = 0; s < 25; ++s) sums[s] = {s < 12 ? 0.0f : 10.0f, s < 12 ? 30.0f : 10.0f};
    const Array<float> smooth = elision_scores(own, sums);
    EXPECT_EQ(smooth[7], 1.0f);
    EXPECT_FLOAT_EQ(smooth[12], 1.0f - 50.0f / (4 * 30.0f + 50.0f));
    EXPECT_EQ(smooth[16], 0.0f);
}

TEST(ElisionOpacity, RefusesWhatMakesNoSense) {
    const Row row(10);
    EXPECT_THROW(row.opacities(filled(9, 1.0f)), std::invalid_argument);
    EXPECT_THROW(row.opacities(filled(10, 1.0f), {.fade_from = 1.0f}), std::invalid_argument);
    EXPECT_THROW(row.opacities(filled(10, 1.0f), {.stub_px = -1.0}), std::invalid_argument);
}
