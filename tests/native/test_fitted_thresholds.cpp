// SPDX-License-Identifier: GPL-3.0-or-later
// Thresholds fitted to a drawing: against brute force, and to synthetic artists who draw with known ones.
#include <cmath>
#include <gtest/gtest.h>
#include <numeric>
#include <random>

#include <fovea/study/fit.h>
#include <fovea/study/measures.h>
#include <fovea/study/nearest_pixel.h>

namespace fovea {
namespace {

using namespace study;

using Thresholds = std::vector<float>;
using Definitions = std::vector<Strengths>;

Strengths nothing(int width, int height) { return {width, height, Array<float>(std::size_t(width * height), -1.0f)}; }

void draw_row(Strengths& strengths, int y, int first, int last, float strength) {
    for (int x = first; x < last; ++x) {
        float& at = strengths.values[std::size_t(y * strengths.width + x)];
        at = std::max(at, strength);
    }
}

/// What is drawn with thresholds.
Bitmap drawn(const Definitions& definitions, const Thresholds& thresholds) {
    Bitmap bitmap(definitions[0].width, definitions[0].height);
    for (std::size_t d = 0; d < definitions.size(); ++d) {
        const Bitmap one = definitions[d].above(thresholds[d]);
        for (std::size_t i = 0; i < one.set.size(); ++i) bitmap.set[i] |= one.set[i];
    }
    return bitmap;
}

/// The score by its definition, pixel for pixel.
double score_of(const Definitions& definitions, const Bitmap& judge, const Thresholds& thresholds,
                const FitOptions& options) {
    const Array<float> to_judge = distances_to(judge);
    std::vector<Array<float>> to_definition;
    std::size_t used = 0;
    for (std::size_t d = 0; d < definitions.size(); ++d) {
        to_definition.push_back(distances_to(definitions[d].above(thresholds[d])));
        used += thresholds[d] < no_threshold;
    }
    double all = 0.0, near = 0.0, recalled = 0.0, judged = 0.0;
    for (std::size_t i = 0; i < to_judge.size(); ++i) {
        int here = 0, beside = 0;
        float nearest = INFINITY;
        for (std::size_t d = 0; d < definitions.size(); ++d) {
            here += to_definition[d][i] == 0.0f;
            beside += to_definition[d][i] < 1.5f;
            nearest = std::min(nearest, to_definition[d][i]);
        }
        if (here) all += double(here) / beside, near += to_judge[i] <= options.tolerance ? double(here) / beside : 0.0;
        if (judge.set[i]) judged += 1.0, recalled += nearest <= options.tolerance;
    }
    const double precision = all > 0.0 ? near / all : 1.0, recall = judged > 0.0 ? recalled / judged : 1.0;
    const double square = options.beta * options.beta, sum = square * precision + recall;
    const double f = sum > 0.0 ? (1.0 + square) * precision * recall / sum : 0.0;
    return f - options.cost * double(used);
}

/// Rows of random lengths and strengths of few values.
Definitions random_definitions(std::size_t count, unsigned seed) {
    std::mt19937 random(seed);
    const auto below = [&](int most) { return int(random() % unsigned(most)); };
    Definitions definitions(count, nothing(40, 30));
    for (Strengths& strengths : definitions)
        for (int i = 0; i < 12; ++i) {
            const int x = below(30);
            draw_row(strengths, below(30), x, x + 1 + below(10), 0.1f * float(1 + below(4)));
        }
    return definitions;
}

Bitmap random_judge(unsigned seed) { return drawn(random_definitions(2, 1000 + seed), {0.1f, 0.1f}); }

/// The best score of all thresholds in steps of their values.
double best_score(const Definitions& definitions, const Bitmap& judge, const FitOptions& options) {
    const Thresholds values{0.1f, 0.2f, 0.3f, 0.4f, no_threshold};
    double best = -INFINITY;
    const auto combinations = std::size_t(std::pow(values.size(), definitions.size()) + 0.5);
    for (std::size_t code = 0; code < combinations; ++code) {
        Thresholds chosen;
        for (std::size_t rest = code, d = 0; d < definitions.size(); ++d, rest /= values.size())
            chosen.push_back(values[rest % values.size()]);
        best = std::max(best, score_of(definitions, judge, chosen, options));
    }
    return best;
}

TEST(FittedThresholds, TheSweepOfOneDefinitionFindsTheBestOfAllItsThresholds) {
    for (unsigned seed = 0; seed < 60; ++seed) {
        const Definitions one = random_definitions(1, seed);
        const Bitmap judge = random_judge(seed);
        const FitOptions options{
            .tolerance = double(seed % 4), .beta = 0.5 + 0.1 * (seed % 16), .slack = 0.0, .starts = 0};
        const Fit found = fitted(one, judge, Thresholds{0.1f}, options);
        EXPECT_NEAR(found.score, best_score(one, judge, options), 1e-9) << seed;
        EXPECT_NEAR(found.score, score_of(one, judge, {found.thresholds[0]}, options), 1e-9) << seed;
    }
}

TEST(FittedThresholds, SeveralDefinitionsAreFittedAsWellAsByTryingAllCombinations) {
    for (unsigned seed = 0; seed < 12; ++seed) {
        const Definitions three = random_definitions(3, seed);
        const Bitmap judge = random_judge(seed);
        const FitOptions options{.tolerance = double(seed % 3), .slack = 0.0};
        const Fit found = fitted(three, judge, Thresholds(3, 0.1f), options);
        const Thresholds thresholds(found.thresholds.begin(), found.thresholds.end());
        EXPECT_NEAR(found.score, score_of(three, judge, thresholds, options), 1e-9) << seed;
        EXPECT_NEAR(found.score, best_score(three, judge, options), 1e-9) << seed;
    }
}

/// Many separate lines of ever more strength, in rows of their own.
Definitions artists_lines(unsigned seed) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<float> strength(0.01f, 1.0f);
    Definitions definitions(4, nothing(400, 300));
    for (int y = 2; y < 298; y += 4)
        for (int x = 0; x < 360; x += 20)
            draw_row(definitions[random() % 4], y, x, x + 8 + int(random() % 9), strength(random));
    return definitions;
}

const Thresholds of_artist{0.2f, 0.5f, 0.8f, no_threshold};

TEST(FittedThresholds, AnArtistsThresholdsAreFoundAgain) {
    for (unsigned seed = 0; seed < 5; ++seed) {
        const Definitions definitions = artists_lines(seed);
        const Bitmap artist = drawn(definitions, of_artist);
        const FitOptions options{.tolerance = 1.0};
        const Fit found = fitted(definitions, artist, Thresholds(4, 0.4f), options);
        EXPECT_GE(found.f(1.0), 1.0 - 3.0 * options.slack);
        for (std::size_t d = 0; d < 3; ++d) EXPECT_NEAR(found.thresholds[d] / of_artist[d], 1.0, 0.1) << seed;
        EXPECT_EQ(found.thresholds[3], no_threshold);
    }
}

TEST(FittedThresholds, LinesOfNoDefinitionLeaveTheThresholdsWhereTheyWere) {
    for (unsigned seed = 0; seed < 5; ++seed) {
        const Definitions definitions = artists_lines(seed);
        Bitmap artist = drawn(definitions, of_artist);
        const std::size_t wanted = artist.count() * 13 / 10;
        std::mt19937 random(seed);
        while (artist.count() < wanted) {  // upright lines, between the rows and across them
            const std::size_t x = random() % 400, y = random() % 290;
            for (std::size_t k = 0; k < 10; ++k) artist.set[(y + k) * 400 + x] = 1;
        }
        const FitOptions options{.tolerance = 1.0};
        const Fit found = fitted(definitions, artist, Thresholds(4, 0.4f), options),
                  own = judged(definitions, artist, of_artist, options);
        EXPECT_GE(found.score, own.score - 3.0 * options.slack) << seed;
        EXPECT_GE(own.f(1.0), 0.85) << seed;
        for (std::size_t d = 0; d < 3; ++d) EXPECT_NEAR(found.thresholds[d] / of_artist[d], 1.0, 0.1) << seed;
        EXPECT_EQ(found.thresholds[3], no_threshold) << seed;
    }
}

TEST(FittedThresholds, AnArtistsLinesThatAreLeftOutAreDrawnForCompletenessAlone) {
    for (unsigned seed = 0; seed < 20; ++seed) {
        const Definitions one = random_definitions(1, seed);
        const Bitmap judge = random_judge(seed);
        double recall = 0.0, precision = 1.0;
        for (const double beta : {0.5, 0.7, 1.0, 1.4, 2.0}) {
            const Fit found =
                fitted(one, judge, Thresholds{0.1f}, {.tolerance = 2.0, .beta = beta, .cost = 0.0, .slack = 0.0});
            EXPECT_GE(found.recall, recall - 1e-9) << seed;
            if (recall > 0.0) {
                EXPECT_LE(found.precision, precision + 1e-9) << seed;
            }
            recall = found.recall, precision = found.precision;
        }
    }
}

TEST(FittedThresholds, OfDefinitionsThatDrawTheSameLinesOneIsDrawn) {
    Definitions two(2, nothing(100, 50));
    draw_row(two[0], 20, 10, 90, 0.5f);
    draw_row(two[1], 21, 10, 90, 0.5f);  // beside it
    const Bitmap artist = two[0].above(0.0f);
    const Fit found = fitted(two, artist, Thresholds{0.5f, 0.5f}, {.tolerance = 2.0});
    EXPECT_EQ(found.f(1.0), 1.0);
    EXPECT_EQ(std::ranges::count(found.thresholds, no_threshold), 1);
}

TEST(FittedThresholds, ALineThatIsDrawnTwiceIsNoMorePreciseThanOnce) {
    Definitions two(2, nothing(100, 50));
    draw_row(two[0], 20, 10, 70, 0.5f);
    draw_row(two[0], 40, 10, 30, 0.5f);  // 20 of 80 pixels are wrong
    Bitmap artist(100, 50);
    for (std::size_t x = 10; x < 70; ++x) artist.set[20 * 100 + x] = 1;
    const FitOptions options{.tolerance = 2.0};
    EXPECT_NEAR(judged(two, artist, Thresholds{0.5f, no_threshold}, options).precision, 0.75, 1e-12);
    draw_row(two[1], 20, 10, 70, 0.5f);
    EXPECT_NEAR(judged(two, artist, Thresholds{0.5f, 0.5f}, options).precision, 0.75, 1e-12);
    two[1] = nothing(100, 50);
    draw_row(two[1], 22, 10, 70, 0.5f);  // another line that is near
    EXPECT_NEAR(judged(two, artist, Thresholds{0.5f, 0.5f}, options).precision, 120.0 / 140.0, 1e-12);
}

TEST(FittedThresholds, OfThresholdsThatAreAsGoodTheMiddleIsTaken) {
    Definitions one(1, nothing(100, 50));
    for (int i = 0; i < 40; ++i) draw_row(one[0], 20, 10 + 2 * i, 12 + 2 * i, 0.1f * std::pow(1.05f, float(i)));
    // Weaker ones are all near, and stronger ones leave a gap that the tolerance bridges: up to a factor of 1.05^9.
    const Bitmap artist = one[0].above(0.0f);
    const auto at = [](double steps) { return 0.1 * std::pow(1.05, steps); };
    const Fit found = fitted(one, artist, Thresholds{0.1f}, {.tolerance = 18.0, .cost = 0.0, .slack = 1e-6});
    EXPECT_NEAR(found.thresholds[0], at(4.5), 0.03 * at(4.5));
    EXPECT_EQ(found.f(1.0), 1.0);
    // Each further step leaves out a fortieth of the drawing; three of them cost 0.039.
    const Fit rough = fitted(one, artist, Thresholds{0.1f}, {.tolerance = 18.0, .cost = 0.0, .slack = 0.05});
    EXPECT_NEAR(rough.thresholds[0], at(6.0), 0.01 * at(6.0));
}

TEST(FittedThresholds, NothingFitsAnEmptyDrawingAndNoLinesDrawNothing) {
    const Definitions one = random_definitions(1, 1), none{nothing(40, 30)};
    const Bitmap empty(40, 30);
    EXPECT_EQ(fitted(one, empty, Thresholds{0.1f}, {.tolerance = 1.0}).thresholds[0], no_threshold);
    const Fit found = fitted(none, random_judge(1), Thresholds{0.1f}, {.tolerance = 1.0});
    EXPECT_EQ(found.thresholds[0], no_threshold);
    EXPECT_EQ(found.recall, 0.0);
    EXPECT_THROW(fitted(one, Bitmap(41, 30), Thresholds{0.1f}, {}), std::invalid_argument);
    EXPECT_THROW(fitted(one, empty, Thresholds{}, {}), std::invalid_argument);
    EXPECT_THROW(fitted(one, empty, Thresholds{0.1f}, {.beta = 0.0}), std::invalid_argument);
}

/// The judging of several drawings in one view.
std::vector<Judging> all_of(const Definitions& definitions, const std::vector<const Bitmap*>& judges) {
    std::vector<Judging> drawings;
    for (const Bitmap* judge : judges) drawings.push_back({judging(definitions, *judge)[0].definitions, judge});
    return drawings;
}

TEST(FittedThresholds, SeveralDrawingsAreFittedTogether) {
    const Definitions definitions = artists_lines(7);
    const Thresholds sparing{0.4f, 0.5f, 0.8f, no_threshold};
    const Bitmap one = drawn(definitions, of_artist), other = drawn(definitions, sparing);
    const FitOptions options{.tolerance = 1.0};
    const auto both = all_of(definitions, {&one, &other}), once = all_of(definitions, {&one, &one});
    const Fit found = fitted(both, Thresholds(4, 0.4f), options);
    const Thresholds thresholds(found.thresholds.begin(), found.thresholds.end());
    const Fit of_one = judged(definitions, one, thresholds, options),
              of_other = judged(definitions, other, thresholds, options);
    // Pixels count, whoever has drawn them.
    const double ones = double(one.count()), others = double(other.count());
    EXPECT_NEAR(found.recall, (ones * of_one.recall + others * of_other.recall) / (ones + others), 1e-12);
    EXPECT_NEAR(found.precision, 0.5 * (of_one.precision + of_other.precision), 1e-12);
    for (const Thresholds& own : {of_artist, sparing})
        EXPECT_GE(found.score, judged(both, own, options).score - 3.0 * options.slack);
    const Fit alone = fitted(definitions, one, Thresholds(4, 0.4f), options);
    EXPECT_EQ(fitted(once, Thresholds(4, 0.4f), options).thresholds, alone.thresholds);
    const std::vector<Judging> other_definitions{both[0], {{&definitions[0]}, &other}};
    EXPECT_THROW(fitted(other_definitions, Thresholds(4, 0.4f), options), std::invalid_argument);
    EXPECT_THROW(fitted(std::vector<Judging>{}, Thresholds(4, 0.4f), options), std::invalid_argument);
}

TEST(FittedThresholds, OfTwoDrawingsEachIsHeldOutOnce) {
    const Definitions definitions = artists_lines(8);
    const Bitmap one = drawn(definitions, of_artist), other = drawn(definitions, {0.4f, 0.5f, no_threshold, 0.9f});
    const FitOptions options{.tolerance = 1.0, .starts = 2};
    double near = 0.0, all = 0.0, recalled = 0.0;
    for (const auto& [kept, held_out] : {std::pair{&one, &other}, std::pair{&other, &one}}) {
        const Fit fit = fitted(definitions, *kept, Thresholds(4, 0.4f), options);
        const Thresholds thresholds(fit.thresholds.begin(), fit.thresholds.end());
        const Fit of = judged(definitions, *held_out, thresholds, options);
        const double pixels = double(drawn(definitions, thresholds).count());  // rows are apart: none counts twice
        near += of.precision * pixels, all += pixels, recalled += of.recall * double(held_out->count());
    }
    const Fit found =
        cross_validated(evidence_of(all_of(definitions, {&one, &other}), 1.0), Thresholds(4, 0.4f), options);
    EXPECT_NEAR(found.precision, near / all, 1e-9);
    EXPECT_NEAR(found.recall, recalled / double(one.count() + other.count()), 1e-9);
    EXPECT_LT(found.f(1.0), 0.95);
}

TEST(FittedThresholds, WhatOneHasDrawnByThresholdsIsAsNearInPartsThatAreHeldOut) {
    for (unsigned seed = 0; seed < 3; ++seed) {
        const Definitions definitions = artists_lines(seed);
        const Bitmap artist = drawn(definitions, of_artist);
        const Fit held_out =
            cross_validated(evidence_of(judging(definitions, artist), 1.0), Thresholds(4, 0.4f), FitOptions{});
        EXPECT_GE(held_out.f(1.0), 0.98) << seed;
    }
}

TEST(FittedThresholds, WhatIsDrawnAtRandomIsFurtherInPartsThatAreHeldOut) {
    double fitted_f = 0.0, held_out_f = 0.0;
    for (unsigned seed = 0; seed < 20; ++seed) {
        const Definitions many = random_definitions(8, seed);
        const Bitmap judge = random_judge(seed);
        const FitOptions options{.tolerance = 1.0};
        fitted_f += fitted(many, judge, Thresholds(8, 0.1f), options).f(1.0);
        held_out_f += cross_validated(evidence_of(judging(many, judge), 1.0), Thresholds(8, 0.1f), options).f(1.0);
    }
    EXPECT_LT(held_out_f, fitted_f - 20 * 0.03);
}

TEST(FittedThresholds, EachPixelIsHeldOutOnceAndKeptElsewhere) {
    const Definitions definitions = artists_lines(1);
    const Bitmap artist = drawn(definitions, of_artist);
    const Evidence all = evidence_of(judging(definitions, artist), 1.0);
    std::size_t held_out = 0, of_judge = 0;
    for (std::size_t fold = 0; fold < all.folds; ++fold) {
        const Evidence part = all.part(fold, true), rest = all.part(fold, false);
        held_out += part.owner.size(), of_judge += part.judged;
        EXPECT_EQ(part.owner.size() + rest.owner.size(), all.owner.size());
        EXPECT_NEAR(double(part.judged) / double(all.judged), 1.0 / double(all.folds), 0.07) << fold;
    }
    EXPECT_EQ(held_out, all.owner.size());
    EXPECT_EQ(of_judge, artist.count());
}

TEST(FittedThresholds, AFitEndsWhenItIsCancelled) {
    const Definitions definitions = artists_lines(1);
    const Bitmap artist = drawn(definitions, of_artist);
    Cancel cancel;
    const Cancelling scope(&cancel);
    const FitOptions options{.tolerance = 1.0};
    EXPECT_NO_THROW(fitted(definitions, artist, Thresholds(4, 0.4f), options));
    const Evidence evidence = evidence_of(judging(definitions, artist), 1.0);
    cancel.requested = true;
    EXPECT_THROW(fitted(definitions, artist, Thresholds(4, 0.4f), options), Cancelled);
    EXPECT_THROW(fitted(evidence, Thresholds(4, 0.4f), options), Cancelled);
    EXPECT_THROW(cross_validated(evidence, Thresholds(4, 0.4f), options), Cancelled);
}

}  // namespace
}  // namespace fovea
