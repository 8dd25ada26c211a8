// SPDX-License-Identifier: GPL-3.0-or-later
// Runs, atlas samples, and the way between them.
#include <algorithm>
#include <array>
#include <cmath>
#include <gtest/gtest.h>
#include <limits>
#include <random>

#include <fovea/runs/filters.h>

#include "wires.h"

using namespace fovea;
using namespace fovea::draw;
using namespace fovea::wires;

namespace {

/// Straight horizontal pieces of the given lengths in pixels, one sample each 2 px.
ClippedPaths pieces_of(const std::vector<std::vector<double>>& lengths) {
    std::vector<std::vector<dvec3>> lines;
    for (std::size_t q = 0; q < lengths.size(); ++q) {
        const double y = 2.4 * ((10.0 + 7.0 * q) / 240.0 - 1.0);
        double x = 10.0;
        lines.push_back({});
        const auto add = [&] { lines[q].push_back({3.2 * (x / 320.0 - 1.0), y, -4}); };
        add();
        for (double length : lengths[q]) {
            x += length;
            add();
        }
    }
    return Wires(lines).project(camera());
}

void add_run(Runs& runs, Index piece, double start, double end) {
    runs.piece.push_back(piece);
    runs.start_px.push_back(start);
    runs.end_px.push_back(end);
    runs.invisibility.push_back(0);
}

Runs closed(const ClippedPaths& clipped, const Runs& runs, double gap, float spur) {
    return close_gaps(clipped, runs, gap, std::vector<float>(clipped.path.empty() ? 0 : clipped.path.back() + 1, spur));
}

}  // namespace

TEST(Runs, ToSamplesAndBack) {
    const ClippedPaths clipped = pieces_of({{400}, {60, 40, 100}, {30}, {7}});
    ASSERT_EQ(clipped.pieces.count(), 4u);
    Runs runs;
    add_run(runs, 0, -200, -120.5);  // from the beginning
    add_run(runs, 0, -33.3, 41.7);
    add_run(runs, 0, 100, 200);  // to the end
    add_run(runs, 1, -50.2, 55.5);
    add_run(runs, 3, -3.5, 3.5);  // all of it; piece 2 has none
    const Array<float> samples = samples_from_runs(clipped, runs);
    ASSERT_EQ(samples.size(), clipped.samples);
    for (float v : samples) EXPECT_TRUE(v >= 0.0f && v <= 1.0f);
    const Runs back = runs_from_samples(clipped, samples);
    ASSERT_EQ(back.piece.size(), runs.piece.size());
    for (std::size_t r = 0; r < runs.piece.size(); ++r) {
        EXPECT_EQ(back.piece[r], runs.piece[r]);
        EXPECT_NEAR(back.start_px[r], runs.start_px[r], 0.6) << r;
        EXPECT_NEAR(back.end_px[r], runs.end_px[r], 0.6) << r;
    }
    EXPECT_NEAR(back.start_px[0], -200.0, 1e-3) << "whole ends stay whole";
    EXPECT_NEAR(back.end_px[2], 200.0, 1e-3);
}

TEST(Runs, ASampleHoldsTheShareThatIsCovered) {
    const ClippedPaths clipped = pieces_of({{100}});
    Runs runs;
    add_run(runs, 0, -41.5, -39.0);  // samples lie at -50 + 2 j
    add_run(runs, 0, -38.5, 10.0);   // a second run in the same sample
    const Array<float> samples = samples_from_runs(clipped, runs);
    const Index start = clipped.sample_start[0];
    EXPECT_NEAR(samples[start + 3], 0.0f, 1e-3f);
    EXPECT_NEAR(samples[start + 4], 0.75f, 1e-3f) << "-42 .. -40";
    EXPECT_NEAR(samples[start + 5], 0.75f, 1e-3f) << "-40 .. -38, but for half a pixel";
    EXPECT_NEAR(samples[start + 6], 1.0f, 1e-3f);
    EXPECT_NEAR(samples[start + 29], 1.0f, 1e-3f);
    EXPECT_NEAR(samples[start + 30], 0.0f, 1e-3f);
}

TEST(Runs, ASampleOfASegmentWithoutLengthIsThatOfTheRunItLiesIn) {
    ClippedPaths clipped = pieces_of({{40, 3, 40}});
    const Index short_one = clipped.pieces.begin(0) + 1;
    ASSERT_GT(clipped.sample_count[short_one], 0u);
    clipped.arc_px[short_one + 1] = clipped.arc_px[short_one];  // as rounding has it, far along a path
    for (const bool visible : {true, false}) {
        Runs runs;
        if (visible) add_run(runs, 0, clipped.first_arc(0), clipped.last_arc(0));
        const Array<float> samples = samples_from_runs(clipped, runs);
        for (Index j = 0; j < clipped.sample_count[short_one]; ++j)
            EXPECT_EQ(samples[clipped.sample_start[short_one] + j], visible ? 1.0f : 0.0f);
        EXPECT_EQ(runs_from_samples(clipped, samples).size(), runs.size());
    }
}

TEST(Runs, EndWhereTheSamplesCrossTheThreshold) {
    const ClippedPaths clipped = pieces_of({{100}});
    Array<float> samples(clipped.samples, 0.0f);
    const Index start = clipped.sample_start[0];
    samples[start + 10] = 0.25f;  // at -29
    samples[start + 11] = 0.75f;  // at -27
    samples[start + 12] = 1.0f;
    samples[start + 13] = 0.5f;  // at -23: still seen
    const Runs runs = runs_from_samples(clipped, samples);
    ASSERT_EQ(runs.piece.size(), 1u);
    EXPECT_NEAR(runs.start_px[0], -28.0, 1e-3);
    EXPECT_NEAR(runs.end_px[0], -23.0, 1e-3);
    EXPECT_EQ(runs_from_samples(clipped, samples, 0.2f).piece.size(), 1u);
    EXPECT_TRUE(runs_from_samples(clipped, samples, 1.0f).piece.empty()) << "a single point has no length";
    EXPECT_TRUE(runs_from_samples(clipped, Array<float>(clipped.samples, 0.0f)).piece.empty());
    EXPECT_EQ(runs_from_samples(clipped, Array<float>(clipped.samples, 1.0f)).piece.size(), 1u);
}

TEST(Runs, WithTheirHiddenPartsCoverEveryPiece) {
    const ClippedPaths clipped = pieces_of({{60.0}, {40.0}});
    Runs visible;
    add_run(visible, 0, -20.0, -5.0);
    add_run(visible, 0, 5.0, 30.0);
    const Runs all = with_hidden(clipped, visible, std::vector<Index>{0, 0});
    const std::vector<std::array<double, 4>> expected = {
        {0, -30, -20, 1}, {0, -20, -5, 0}, {0, -5, 5, 1}, {0, 5, 30, 0}, {1, -20, 20, 1}};
    ASSERT_EQ(all.size(), expected.size());
    for (std::size_t r = 0; r < all.size(); ++r) {
        EXPECT_EQ(all.piece[r], expected[r][0]) << r;
        EXPECT_NEAR(all.start_px[r], expected[r][1], 1e-3) << r;
        EXPECT_NEAR(all.end_px[r], expected[r][2], 1e-3) << r;
        EXPECT_EQ(all.invisibility[r], expected[r][3]) << r;
    }
    EXPECT_EQ(samples_from_runs(clipped, all), samples_from_runs(clipped, visible)) << "hidden parts cover no sample";
    EXPECT_EQ(with_hidden(clipped, visible, std::vector<Index>{0, none}).size(), 4u) << "lines of the image";
}

TEST(Runs, WhoseEndsCoincideAreNone) {
    Runs runs;
    runs.push(0, 1.0, 1.0 + 0.5 * same_place_px);
    runs.push(0, 1.0, 1.0 + 2.0 * same_place_px);
    runs.push(0, 3.0, std::nan(""));
    EXPECT_EQ(runs.end_px, Array<double>{1.0 + 2.0 * same_place_px});
}

TEST(Runs, AreFiniteWhateverTheSamples) {
    const ClippedPaths clipped = pieces_of({{100}, {50, 3}});
    std::mt19937 random(9);
    const float values[] = {0.0f, 1.0f, 0.5f, std::numeric_limits<float>::quiet_NaN(), 2.0f, -1.0f};
    for (int k = 0; k < 50; ++k) {
        Array<float> samples(clipped.samples);
        for (float& v : samples) v = values[random() % 6];
        const Runs runs = runs_from_samples(clipped, samples);
        for (std::size_t r = 0; r < runs.piece.size(); ++r) {
            EXPECT_TRUE(std::isfinite(runs.start_px[r]) && std::isfinite(runs.end_px[r]));
            EXPECT_LT(runs.start_px[r], runs.end_px[r]);
        }
    }
    EXPECT_THROW(runs_from_samples(clipped, Array<float>(clipped.samples - 1, 0.0f)), std::invalid_argument);
}

TEST(TrimFolds, CutsTheWayBackOffTheEndsOfContours) {
    // 100 px to the right, back by 20 px a little above, and away; and the same from its other end.
    const auto at = [](double x, double y) { return dvec3(3.2 * (x / 320.0 - 1.0), 2.4 * (y / 240.0 - 1.0), -4); };
    std::vector<dvec3> way{at(100, 100), at(200, 100), at(180, 102), at(180, 160)};
    for (int turned = 0; turned < 2; ++turned) {
        const ClippedPaths clipped = Wires({way}).project(camera());
        const double first = clipped.arc_px[0], last = clipped.arc_px[3], fold = clipped.arc_px[turned ? 2 : 1];
        const auto trimmed = [&](double seen_back, double fold_px, std::uint8_t of_view) {
            Runs runs;
            if (turned) {
                add_run(runs, 0, fold - seen_back, last);
            } else {
                add_run(runs, 0, first, fold + seen_back);
            }
            const Runs result = trim_folds(clipped, runs, std::vector<std::uint8_t>{of_view}, fold_px);
            return turned ? fold - result.start_px[0] : result.end_px[0] - fold;
        };
        EXPECT_NEAR(trimmed(8, 12, 1), 0.0, 1e-9);
        EXPECT_NEAR(trimmed(8, 12, 0), 8.0, 1e-9) << "not a line of the view";
        EXPECT_NEAR(trimmed(8, 5, 1), 8.0, 1e-9) << "too long a way back";
        EXPECT_NEAR(trimmed(60, 80, 1), 60.0, 1e-9) << "it goes on elsewhere";
        std::vector<dvec3> short_way(turned ? way.begin() + 1 : way.begin(), turned ? way.end() : way.end() - 1);
        const ClippedPaths ending = Wires({short_way}).project(camera());
        const auto whole = [&](std::uint8_t of_view) {
            Runs runs;
            add_run(runs, 0, ending.arc_px[0], ending.arc_px[2]);
            const Runs result = trim_folds(ending, runs, std::vector<std::uint8_t>{of_view}, 30);
            return turned ? ending.arc_px[1] - result.start_px[0] : result.end_px[0] - ending.arc_px[1];
        };
        EXPECT_NEAR(whole(1), glm::length(vec2(20, 2)), 0.1) << "the line's own end";
        EXPECT_NEAR(whole(ends_at_cusps), 0.0, 1e-9);
        std::reverse(way.begin(), way.end());
    }
}

TEST(MeetEnds, ContoursGoOnToLinesThatGoOnFromThere) {
    // A contour of 100 px, of which the last 6 are hidden; a line before it goes on from x = 196, a pixel above.
    const auto at = [](double x, double y) { return dvec3(3.2 * (x / 320.0 - 1.0), 2.4 * (y / 240.0 - 1.0), -4); };
    const auto end_of = [&](const std::vector<dvec3>& other, std::uint8_t of_view, Index placement, double seen,
                            double reach = 8.0) {
        const ClippedPaths clipped = Wires({{at(100, 100), at(200, 100)}, other}).project(camera());
        Runs runs;
        add_run(runs, 0, -50.0, seen);
        runs.push(0, seen, 50.0, 1);
        add_run(runs, 1, clipped.arc_px[clipped.pieces.begin(1)], clipped.arc_px[clipped.pieces.end(1) - 1]);
        const Runs met =
            meet_ends(clipped, runs, std::vector<std::uint8_t>{of_view, 0}, std::vector<Index>{0, placement}, reach);
        EXPECT_EQ(met.start_px[0], -50.0);
        const double rest = met.size() == 3 ? met.end_px[1] - met.start_px[1] : 0.0;
        EXPECT_NEAR(rest, std::max(0.0, 50.0 - met.end_px[0]), 1e-9) << "the hidden part gives way";
        return met.end_px[0];
    };
    const std::vector<dvec3> onward{at(196, 101), at(300, 101)}, back{at(300, 101), at(196, 101)};
    EXPECT_NEAR(end_of(onward, 1, 0, 44.0 - 4.0), 46.0, 0.51);
    EXPECT_NEAR(end_of(back, 1, 0, 40.0), 46.0, 0.51) << "whichever way it was found";
    EXPECT_EQ(end_of(onward, 0, 0, 40.0), 40.0) << "not a line of the view";
    EXPECT_EQ(end_of(onward, 1, 1, 40.0), 40.0) << "another object";
    EXPECT_EQ(end_of(onward, 1, 0, 35.0), 35.0) << "too far";
    EXPECT_EQ(end_of({at(196, 105), at(300, 105)}, 1, 0, 40.0), 40.0) << "beside";
    EXPECT_EQ(end_of({at(196, 101), at(100, 101)}, 1, 0, 40.0), 40.0) << "a line that comes from there";
    EXPECT_EQ(end_of({at(196, 101), at(196, 200)}, 1, 0, 40.0), 40.0) << "a corner";
    EXPECT_NEAR(end_of({at(202.5, 100), at(300, 100)}, 1, 0, 50.0), 52.5, 0.01) << "straight on beyond its end";
    EXPECT_NEAR(end_of({at(206, 100), at(300, 100)}, 1, 0, 50.0), 50.0, 0.01) << "but not far";
    EXPECT_THROW(end_of(onward, 1, 0, 40.0, 0.0), std::invalid_argument);
}

TEST(CloseGaps, JoinsShortGapsAndDropsShortSpurs) {
    const ClippedPaths clipped = pieces_of({{100}, {100}});
    Runs runs;
    add_run(runs, 0, -50, -49.5);  // short, but at the beginning
    add_run(runs, 0, -40, -30);
    add_run(runs, 0, -28.5, -20);  // gap of 1.5
    add_run(runs, 0, 0, 0.5);      // a spur
    add_run(runs, 0, 10, 10.4);    // two spurs that make a line together
    add_run(runs, 0, 10.8, 11.4);
    add_run(runs, 0, 49.8, 50);  // at the end
    add_run(runs, 1, -50, 50);   // another piece is never joined
    const Runs kept = closed(clipped, runs, 2.0, 1.0f);
    const std::vector<std::pair<double, double>> expected{{-50, -49.5}, {-40, -20}, {10, 11.4}, {49.8, 50}, {-50, 50}};
    ASSERT_EQ(kept.piece.size(), expected.size());
    for (std::size_t r = 0; r < expected.size(); ++r)
        EXPECT_EQ(std::pair(kept.start_px[r], kept.end_px[r]), expected[r]) << r;
    EXPECT_EQ(kept.piece.back(), 1u);

    const Runs same = closed(clipped, runs, 0.0, 0.0f);
    EXPECT_EQ(same.start_px, runs.start_px);
    EXPECT_EQ(closed(clipped, kept, 2.0, 1.0f).start_px, kept.start_px) << "done twice, nothing more changes";
    EXPECT_TRUE(closed(clipped, Runs(), 2.0, 1.0f).piece.empty());
}

TEST(Runs, ShortHiddenStretchesAreLeftOutAndVisibleOnesStay) {
    const ClippedPaths clipped = pieces_of({{100}, {100}, {8}});
    Runs runs;
    for (Index piece : {0, 1}) {
        runs.push(piece, -50, -20, 0);
        runs.push(piece, -20, -12, 1);  // 8 px in all
        runs.push(piece, -12, -10, 0);
        runs.push(piece, -10, -5, 2);  // 9 px, of which
        runs.push(piece, -5, -1, 1);   // neither has as many
        runs.push(piece, -1, 47, 0);
        runs.push(piece, 47, 50, 1);  // at the end
    }
    runs.push(2, -4, 4, 1);  // a whole piece
    const std::vector<float> least{9.0f, 1.0f, 100.0f};
    const Runs kept = without_short_hidden(clipped, runs, least);
    const auto of_piece = [&](Index piece) {
        std::vector<std::array<double, 3>> found;
        for (std::size_t r = 0; r < kept.size(); ++r)
            if (kept.piece[r] == piece)
                found.push_back({kept.start_px[r], kept.end_px[r], double(kept.invisibility[r])});
        return found;
    };
    const std::vector<std::array<double, 3>> first{
        {-50, -20, 0}, {-12, -10, 0}, {-10, -5, 2}, {-5, -1, 1}, {-1, 47, 0}};
    EXPECT_EQ(of_piece(0), first);
    EXPECT_EQ(of_piece(1).size(), 7u) << "long enough for that path";
    EXPECT_EQ(of_piece(2).size(), 1u);
    EXPECT_THROW(without_short_hidden(clipped, runs, {}), std::invalid_argument);
}
