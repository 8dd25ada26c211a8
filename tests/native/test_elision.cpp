// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <gtest/gtest.h>
#include <numbers>
#include <random>
#include <tbb/global_control.h>

#include "elision_fixture.h"

using namespace fovea;
using namespace fovea::draw;

namespace {

constexpr double pi = std::numbers::pi;

double mean(const std::vector<float>& values) {
    double sum = 0.0;
    for (const float v : values) sum += v;
    return sum / double(values.size());
}

/// A line and, `apart` px to its left, a more important one along it.
Sheet two_lines(double angle, double apart, float half_width, vec2 middle = {100.3f, 80.1f}) {
    Sheet sheet;
    sheet.half_width = half_width;
    const vec2 left(float(-std::sin(angle)), float(std::cos(angle)));
    sheet.line(Sheet::through(middle + left * float(apart), angle, 90.0));
    sheet.line(Sheet::through(middle, angle, 90.0));
    return sheet;
}

}  // namespace

TEST(Elision, ALineAloneKeepsItsBandWhicheverWayItLies) {
    for (const float half_width : {0.0f, 0.5f, 1.0f, 2.5f, 4.0f, 8.0f, 30.0f})
        for (int k = 0; k < 64; ++k) {
            Sheet sheet;
            sheet.half_width = half_width;
            sheet.line(Sheet::through({100.0f + float(k) * 0.131f, 80.0f + float(k) * 0.077f}, k * pi / 64.0, 80.0));
            for (const float score : sheet.of(0, sheet.scores())) ASSERT_EQ(score, 1.0f) << half_width << " " << k;
        }
}

TEST(Elision, HalfUnderAnotherIsHalfLeft) {
    for (const float half_width : {1.0f, 1.5f, 3.0f, 4.0f, 8.0f, 30.0f})
        for (int k = 0; k < 64; ++k) {
            const Sheet sheet = two_lines(k * pi / 32.0, half_width, half_width,
                                          {100.0f + float(k) * 0.131f, 80.0f + float(k) * 0.077f});
            const Array<float> scores = sheet.scores();
            for (const float score : sheet.of(1, scores, 12.0 + 0.25 * half_width))
                ASSERT_NEAR(score, 0.5, 0.1) << half_width << " " << k;
            for (const float score : sheet.of(0, scores)) ASSERT_EQ(score, 1.0f);
        }
}

TEST(Elision, TwoLinesAreBothWholeOnlyWhereTheyAreAsFarApartAsTheyWant) {
    for (const float half_width : {0.5f, 1.0f, 3.0f, 6.0f, 12.0f})
        for (int k = 0; k < 32; ++k)
            for (int d = 0; d <= 12; ++d) {
                const double apart = 2.0 * half_width * d / 10.0;
                const Sheet sheet = two_lines(k * pi / 16.0 + 0.05, apart, half_width);
                const std::vector<float> left = sheet.of(1, sheet.scores(), 12.0);
                if (d < 10) {
                    EXPECT_LT(std::ranges::max(left), 1.0f - 0.3f * (1.0f - float(d) / 10.0f))
                        << half_width << " " << k << " " << d;
                } else {
                    EXPECT_GT(std::ranges::min(left), 0.995f) << half_width << " " << k << " " << d;
                }
                EXPECT_NEAR(mean(left), std::min(1.0, apart / (2.0 * half_width)), 0.5 / (2.0 * half_width) + 0.02);
            }
}

TEST(Elision, OnTopOfAnotherNothingIsLeft) {
    for (int k = 0; k < 32; ++k) {
        const Sheet sheet = two_lines(k * pi / 32.0, 0.0, 4.0f);
        const Array<float> scores = sheet.scores();
        for (const float score : sheet.of(1, scores)) EXPECT_LT(score, 0.15f) << k;
        for (const float score : sheet.of(1, scores, 12.0)) EXPECT_LT(score, 0.02f) << k;
    }
}

TEST(Elision, LinesThatCrossOrMeetAtALargeAngleStayWhole) {
    for (int k = 0; k < 32; ++k)
        for (const double between : {61.0, 75.0, 90.0}) {
            const double angle = k * pi / 16.0, other = angle + between * pi / 180.0;
            Sheet sheet;
            sheet.line(Sheet::through({100.0f, 80.0f}, other, 90.0));
            sheet.line(Sheet::through({100.0f, 80.0f}, angle, 90.0));                                   // crosses
            sheet.line({{100.0f, 80.0f}, Sheet::through({100.0f, 80.0f}, angle + 0.01, 90.0).back()});  // under it
            const Array<float> scores = sheet.scores();
            for (const float score : sheet.of(1, scores)) ASSERT_GT(score, 0.999f) << k;
        }
}

TEST(Elision, BehindALineThatCrossesLinesThatGoAlongStillCrowd) {
    Sheet sheet;
    sheet.half_width = 6.0f;
    sheet.line(Sheet::through({100.0f, 80.0f}, pi / 2.0, 90.0));  // crosses both
    sheet.line(Sheet::through({100.0f, 84.0f}, 0.0, 90.0));
    sheet.line(Sheet::through({100.0f, 80.0f}, 0.0, 90.0));
    const std::vector<float> left = sheet.of(2, sheet.scores(), 12.0);
    EXPECT_NEAR(std::ranges::max(left), 1.0 / 3.0, 0.05);
}

TEST(Elision, TheMoreTheyTurnApartTheLessLinesCrowd) {
    float before = 0.0f;
    for (int degrees = 0; degrees <= 90; degrees += 5) {
        Sheet sheet;
        sheet.line(Sheet::through({100.0f, 80.0f}, degrees * pi / 180.0, 60.0));
        sheet.line(Sheet::through({100.0f, 80.0f}, 0.0, 60.0));
        const std::vector<float> left = sheet.of(1, sheet.scores());
        const float at_crossing = left[left.size() / 2];
        EXPECT_GE(at_crossing, before - 0.02f) << degrees;
        before = at_crossing;
    }
    EXPECT_EQ(before, 1.0f);
}

TEST(Elision, OneLineAfterTheOtherDoNotCrowd) {
    for (int k = 0; k < 16; ++k)
        for (const double bend : {0.0, 0.1, 0.2}) {
            const double angle = k * pi / 8.0 + 0.03;
            const vec2 corner(100.0f, 80.0f);
            Sheet sheet;
            sheet.line({corner, Sheet::through(corner, angle + pi + bend, 120.0).back()});
            sheet.line({corner, Sheet::through(corner, angle, 120.0).back()});
            for (const float score : sheet.of(1, sheet.scores())) EXPECT_GT(score, 0.97f) << k << " " << bend;
        }
}

TEST(Elision, ALineThatGoesOnTakesOverWhereAnotherEnds) {
    // The higher one ends at the middle, the lower one begins some way before, beside it, and goes on.
    for (int k = 0; k < 32; ++k)
        for (const double beside : {0.0, 1.0})
            for (const double overlap : {0.0, 4.0, 10.0, 20.0}) {
                const double angle = k * pi / 16.0 + 0.03;
                const vec2 along(float(std::cos(angle)), float(std::sin(angle)));
                const vec2 left(-along.y, along.x), end(100.3f, 80.1f), aside = left * float(beside);
                Sheet sheet;
                sheet.half_width = 1.5f;
                sheet.line({end - along * 60.0f, end});
                sheet.line({end + aside - along * float(overlap), end + aside + along * 60.0f});
                const std::vector<float> left_of_it = sheet.of(1, sheet.scores());
                for (std::size_t s = 0; s < left_of_it.size(); ++s) {
                    const double beyond = (double(s) + 0.5) * (60.0 + overlap) / double(left_of_it.size()) - overlap;
                    if (beyond < 0.0) continue;
                    EXPECT_GT(left_of_it[s], 0.9f) << k << " " << beside << " " << overlap << " " << s;
                }
            }
}

TEST(Elision, ALineThatEndsWithAnotherDoesNotTakeOver) {
    const Sheet sheet = two_lines(0.3, 1.0, 3.0f);
    const std::vector<float> left = sheet.of(1, sheet.scores());
    EXPECT_NEAR(left.front(), left[left.size() / 2], 0.1);
    EXPECT_NEAR(left.back(), left[left.size() / 2], 0.1);
}

TEST(Elision, HiddenRunsGoBelowVisibleOnes) {
    Sheet sheet;
    sheet.line(Sheet::through({100.0f, 82.0f}, 0.0, 90.0), 1);
    sheet.line(Sheet::through({100.0f, 80.0f}, 0.0, 90.0));
    const Array<float> scores = sheet.scores();
    EXPECT_EQ(mean(sheet.of(1, scores)), 1.0);
    EXPECT_LT(mean(sheet.of(0, scores)), 0.4);
}

TEST(Elision, APixelOfMovementChangesLittle) {
    // Of 8 px bands each pixel of movement takes an eighth, .19 of opacity; more where lines begin or end to meet.
    std::mt19937 random(3);
    std::uniform_real_distribution<float> x(20.0f, 180.0f), y(20.0f, 140.0f), turn(0.0f, 3.1f);
    std::vector<std::vector<vec2>> lines;
    for (int k = 0; k < 40; ++k) lines.push_back(Sheet::through({x(random), y(random)}, turn(random), 59.0));
    for (const float d : {0.1f, 1.0f}) {
        Sheet before, after;
        for (std::size_t k = 0; k < lines.size(); ++k) {
            before.line(lines[k]);
            const vec2 by = k % 2 ? vec2(d * 0.7f) : vec2(0.0f);
            after.line({lines[k][0] + by, lines[k][1] + by});
        }
        const Array<float> a = before.opacities(), b = after.opacities();
        ASSERT_EQ(a.size(), b.size());
        float most = 0.0f;
        double sum = 0.0;
        for (std::size_t s = 0; s < a.size(); ++s) {
            most = std::max(most, std::abs(a[s] - b[s]));
            sum += std::abs(a[s] - b[s]);
        }
        EXPECT_LT(most, 0.1f + 0.6f * d) << d;
        EXPECT_LT(sum / double(a.size()), 0.005 + 0.04 * d) << d;
    }
}

TEST(Elision, APathInManySegmentsIsThatInOne) {
    for (const int parts : {2, 7, 30}) {
        Sheet whole = two_lines(0.4, 5.0, 4.0f), split;
        split.half_width = whole.half_width;
        for (Index q = 0; q < 2; ++q) {
            const vec2 a = whole.clipped.px[2 * q], b = whole.clipped.px[2 * q + 1];
            std::vector<vec2> points;
            for (int k = 0; k <= parts; ++k) points.push_back(glm::mix(a, b, float(k) / float(parts)));
            split.line(points);
        }
        EXPECT_NEAR(mean(whole.of(1, whole.scores(), 10.0)), mean(split.of(1, split.scores(), 10.0)), 0.02) << parts;
    }
}

TEST(Elision, RowsOfTheAtlasAreNoBorders) {
    // The second pair of lines lies over the seam of two rows of 2048 samples, wherever it is.
    std::vector<float> first;
    for (const int before : {0, 2026, 2041}) {
        Sheet sheet;
        sheet.step_px = 0.5f;
        sheet.line({{0.0f, -500.0f}, {0.0f, -500.0f + float(before) * 0.5f}});
        sheet.line(Sheet::through({100.0f, 83.0f}, 0.3, 60.0));
        sheet.line(Sheet::through({100.0f, 80.0f}, 0.1, 60.0));
        const std::vector<float> left = sheet.of(2, sheet.scores());
        if (first.empty()) first = left;
        EXPECT_EQ(left, first) << before;
    }
}

TEST(Elision, WhatNoRunsLieOnIsNotAskedHowWideItWantsToBe) {
    Sheet sheet;
    sheet.line({{20, 60}, {180, 60}});
    sheet.line({{20, 66}, {180, 66}});
    sheet.line({{20, 63}, {180, 63}});
    sheet.runs.piece.pop_back();
    sheet.runs.start_px.pop_back();
    sheet.runs.end_px.pop_back();
    sheet.runs.invisibility.pop_back();
    std::vector<float> wide(sheet.clipped.samples, 4.0f), none = wide;
    std::fill(none.begin() + sheet.clipped.sample_start[4], none.end(), 0.0f);
    const Array<float> found = sheet.scores(sheet.own(wide));
    EXPECT_EQ(found, sheet.scores(sheet.own(none)));
    EXPECT_LT(std::ranges::min(sheet.of(1, found)), 1.0f);
    for (const float score : sheet.of(2, found)) EXPECT_EQ(score, 1.0f);
}

TEST(Elision, WidthsVaryAlongTheLine) {
    Sheet sheet = two_lines(0.0, 6.0, 4.0f);
    std::vector<float> half_widths(sheet.clipped.samples);
    for (std::size_t s = 0; s < half_widths.size(); ++s) half_widths[s] = 1.0f + 5.0f * float(s % 45) / 44.0f;
    const std::vector<float> left = sheet.of(1, sheet.scores(sheet.own(half_widths)), 10.0);
    EXPECT_EQ(left.front(), 1.0f);
    for (std::size_t k = 1; k < left.size(); ++k) EXPECT_LT(left[k], left[k - 1] + 0.01f);
    EXPECT_NEAR(left.back(), 0.6, 0.12);
}

TEST(Elision, LinesBeyondThePictureAreLeftAlone) {
    Sheet sheet;
    sheet.line({{-50.0f, 40.0f}, {60.0f, 40.0f}});
    sheet.line({{-50.0f, 42.0f}, {60.0f, 42.0f}});
    sheet.line({{-50.0f, -90.0f}, {60.0f, -90.0f}});
    const Array<float> scores = sheet.scores();
    EXPECT_EQ(sheet.of(1, scores).front(), 1.0f);
    EXPECT_LT(sheet.of(1, scores).back(), 0.4f);
    EXPECT_EQ(mean(sheet.of(2, scores)), 1.0);
}

TEST(Elision, NothingToElide) {
    Sheet sheet;
    EXPECT_TRUE(sheet.scores().empty());
    EXPECT_TRUE(sheet.opacities().empty());
    sheet.line(Sheet::through({100.0f, 80.0f}, 0.0, 90.0));
    sheet.runs = Runs();
    for (const float opacity : sheet.opacities()) EXPECT_EQ(opacity, 1.0f);
    EXPECT_THROW(draw_priorities(Bands(), 0, 10), std::invalid_argument);
    EXPECT_THROW(sheet.own(std::vector<float>(3)), std::invalid_argument);
}

TEST(Elision, TheSameForAnyNumberOfThreads) {
    Sheet sheet;
    std::mt19937 random(5);
    std::uniform_real_distribution<float> x(-10.0f, 210.0f), y(-10.0f, 170.0f);
    for (int k = 0; k < 300; ++k) sheet.line({{x(random), y(random)}, {x(random), y(random)}, {x(random), y(random)}});
    const Array<float> many = sheet.opacities();
    tbb::global_control one(tbb::global_control::max_allowed_parallelism, 1);
    EXPECT_EQ(many, sheet.opacities());
}

TEST(Elision, TheBufferHoldsTheHighestAndTheNextThatCrossesIt) {
    Sheet sheet;
    for (const double degrees : {0.0, 20.0, 90.0, 100.0})
        sheet.line(Sheet::through({100.5f, 80.5f}, degrees * pi / 180.0, 60.0));
    const PriorityBuffer buffer = sheet.buffer(sheet.own());
    const std::size_t middle = 80 * 200 + 100;
    EXPECT_EQ(buffer.first[middle].rank, 4u);
    EXPECT_TRUE(buffer.first[middle].crossed);
    EXPECT_EQ(buffer.second[middle].rank, 2u);
    EXPECT_EQ(buffer.first[0].rank, 0u);
    EXPECT_FALSE(buffer.first[80 * 200 + 80].crossed);
    // Away from the middle of the line is down below it, and up above.
    EXPECT_LT(buffer.first[78 * 200 + 90].away_y, -0.99f * PriorityTexel::away_unit);
    EXPECT_GT(buffer.first[82 * 200 + 90].away_y, 0.99f * PriorityTexel::away_unit);
}

TEST(Elision, LinesThatMeetStayClosedDownToAcuteCorners) {
    for (int k = 0; k < 32; ++k)
        for (const double between : {26.0, 40.0, 90.0}) {
            const double angle = k * pi / 16.0;
            const vec2 corner(100.0f + 0.1f * float(k), 80.0f), aside = Sheet::through(corner, angle, 10.0).back();
            Sheet sheet;
            sheet.line(Sheet::through(corner, angle + between * pi / 180.0, 120.0));
            sheet.line({corner, Sheet::through(corner, angle, 130.0).back()});
            sheet.line({aside, Sheet::through(corner, angle, 130.0).back()});
            const Array<float> scores = sheet.scores();
            for (const float score : sheet.of(1, scores)) ASSERT_GT(score, 0.96f) << k << " " << between;
        }
}

TEST(Elision, TicksGoAtAnyAngleUnlessNothingIsNear) {
    Sheet sheet;
    sheet.half_width = 6.0f;
    sheet.line({{20.0f, 80.0f}, {180.0f, 80.0f}});
    for (const float length : {4.0f, 12.0f, 30.0f})
        sheet.line({{50.0f + length, 80.0f}, {50.0f + length, 80.0f + length}});
    sheet.line({{100.0f, 120.0f}, {100.0f, 124.0f}});
    const Array<float> scores = sheet.scores();
    EXPECT_LT(mean(sheet.of(1, scores)), 0.05);
    EXPECT_LT(mean(sheet.of(2, scores)), mean(sheet.of(3, scores)));
    EXPECT_EQ(mean(sheet.of(3, scores)), 1.0);
    EXPECT_EQ(mean(sheet.of(4, scores)), 1.0);
}

TEST(Elision, NoTwoWholeLinesGoAlongNearerThanTheyWant) {
    // In a thicket of lines, away from their ends, where they may meet. Few slip through below two others that cross.
    Sheet sheet;
    sheet.width = 800;
    sheet.height = 600;
    std::mt19937 random(7);
    std::uniform_real_distribution<float> x(0.0f, 800.0f), y(0.0f, 600.0f), turn(0.0f, 3.14f), length(30.0f, 300.0f);
    for (int k = 0; k < 400; ++k) sheet.line(Sheet::through({x(random), y(random)}, turn(random), length(random)));
    const OwnBands own = sheet.own();
    const Array<float> scores = elision_scores(own, crowding(own, sheet.buffer(own)));
    std::vector<std::size_t> whole;
    for (std::size_t s = 0; s < scores.size(); ++s) {
        const vec4 place = own.place[s], band = own.band[s];
        const bool inside = place.x > 0.0f && place.y > 0.0f && place.x < 800.0f && place.y < 600.0f;
        if (inside && scores[s] > 0.99f && std::min(band.z, band.w) > 40.0f) whole.push_back(s);
    }
    ASSERT_GT(whole.size(), 500u);
    int crowded = 0;
    for (const std::size_t s : whole)
        crowded += std::ranges::any_of(whole, [&](std::size_t t) {
            const vec2 along(own.place[s].z, own.place[s].w), way = vec2(own.place[t]) - vec2(own.place[s]);
            const float angle = glm::dot(along, vec2(own.place[t].z, own.place[t].w));
            const float aside = std::abs(along.x * way.y - along.y * way.x);
            return own.band[s].y != own.band[t].y && angle * angle > 0.75f && std::abs(glm::dot(along, way)) < 1.0f &&
                   aside < 7.0f;
        });
    EXPECT_LT(crowded, int(whole.size() / 100)) << whole.size();
}
