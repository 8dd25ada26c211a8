// SPDX-License-Identifier: GPL-3.0-or-later
// Gaps and overshoot: along segments and atlas rows, over seams, up to the frame and beyond the ends of lines.
#include <cmath>
#include <gtest/gtest.h>
#include <limits>
#include <numbers>
#include <tbb/global_control.h>

#include "line_filters.h"

using namespace fovea;
using namespace fovea::draw;
using namespace fovea::line_filters;

namespace {

/// A horizontal line of 200 px.
ClippedPaths straight() { return Wires({{at(100, 100), at(300, 100)}}).project(camera()); }

/// A ring of 32 corners around a place in the image, its seam at the angle of the first.
std::vector<dvec3> ring(double x, double y, double radius, int first = 0) {
    std::vector<dvec3> line;
    for (int i = 0; i <= 32; ++i) {
        const double a = 2.0 * std::numbers::pi * ((i + first) % 32) / 32.0;
        line.push_back(at(x + radius * std::cos(a), y + radius * std::sin(a)));
    }
    return line;
}

/// Lines, rings and lines that the frame cuts.
ClippedPaths of_all_kinds() {
    std::vector<std::vector<dvec3>> lines{ring(100, 100, 50),
                                          ring(640, 240, 80),
                                          ring(640, 240, 100, 16),
                                          {at(-300, 30), at(900, 40), at(900, 80), at(-300, 90)}};
    for (int k = 0; k < 300; ++k) lines.push_back(divided(at(50, 0.5 * k), at(450, 0.6 * k), 1 + k % 7));
    return Wires(lines).project(camera());
}

}  // namespace

TEST(Pieces, KnowHowTheyEnd) {
    const ClippedPaths clipped = of_all_kinds();
    const auto ends_of = [&](Index path) {
        std::vector<int> ends;
        for (Index q = 0; q < clipped.path.size(); ++q)
            if (clipped.path[q] == path) ends.push_back(clipped.ends[q]);
        return ends;
    };
    EXPECT_EQ(ends_of(0), std::vector<int>{seam_start | seam_end});
    EXPECT_EQ(ends_of(1), std::vector<int>{0}) << "the seam lies beyond the frame";
    EXPECT_EQ(ends_of(2), (std::vector<int>{seam_start, seam_end}));
    EXPECT_EQ(ends_of(3), (std::vector<int>{0, 0})) << "the frame cuts it on both sides, there and back";
    EXPECT_EQ(ends_of(4), std::vector<int>{path_start | path_end});
}

TEST(Overshoot, StopsWhereASurfaceHidesTheLine) {
    const ClippedPaths clipped = straight();
    const Runs runs = runs_of({{0, -80, -50}, {0, -40, -20}, {0, 30, 60}});
    for (float amount : {4.0f, 5.0f, 40.0f}) expect_same(overshoot(clipped, runs, everywhere(clipped, amount)), runs);
    expect_runs(overshoot(clipped, runs_of({{0, -100, 20}, {0, 40, 100}}), everywhere(clipped, 9)),
                {{0, -109, 20}, {0, 40, 109}});
}

TEST(Overshoot, OfLessThanNothingDrawsBackEveryEnd) {
    const ClippedPaths clipped = straight();
    const Runs runs = runs_of({{0, -80, -50}, {0, -40, -20}, {0, 30, 60}});
    expect_runs(overshoot(clipped, runs, everywhere(clipped, -4)), {{0, -76, -54}, {0, -36, -24}, {0, 34, 56}});
    expect_runs(overshoot(clipped, runs, everywhere(clipped, -10)), {{0, -70, -60}, {0, 40, 50}});
    EXPECT_EQ(overshoot(clipped, runs, everywhere(clipped, -15)).size(), 0u);
    expect_runs(overshoot(clipped, runs_of({{0, -20, 0}, {0, 0, 20}}), everywhere(clipped, -3)), {{0, -17, 17}});
}

TEST(Overshoot, GoesBeyondTheEndsOfALineButNotBeyondTheFrame) {
    const ClippedPaths line = straight();
    expect_runs(overshoot(line, whole(line), everywhere(line, 7)), {{0, -107, 107}});
    expect_runs(overshoot(line, whole(line), everywhere(line, -7)), {{0, -93, 93}});
    const ClippedPaths cut = Wires({{at(100, 100), at(900, 100)}}).project(camera());
    const double first = cut.arc_px[0], last = cut.arc_px[1];
    for (float amount : {7.0f, -7.0f})
        expect_runs(overshoot(cut, whole(cut), everywhere(cut, amount)), {{0, first - amount, last}});
}

TEST(Overshoot, GoesOverAHiddenPixelAtTheEndOfALine) {
    const ClippedPaths line = straight();
    double before = 107.0;
    for (double rest = 0.0; rest < 4.0; rest += 0.125) {
        const Runs runs = runs_of({{0, 20, 100 - rest}, {0, 100 - rest, 100, 1}});
        const Runs longer = overshoot(line, runs, everywhere(line, 7));
        const double end = longer.end_px[0];
        EXPECT_NEAR(end, 100 - rest + (rest <= 1.0 ? 7.0 : rest < 2.0 ? 7.0 * (2.0 - rest) : 0.0), 1e-3) << rest;
        EXPECT_LE(std::abs(end - before), 0.125 * 8.0 + 1e-6) << "no step, so that it is steady while something moves";
        before = end;
    }
    expect_runs(overshoot(line, runs_of({{0, -100, -99, 1}, {0, -99, 0}, {0, 0, 100, 2}}), everywhere(line, 7)),
                {{0, -106, 0}, {0, 0, 100, 2}});
}

TEST(Overshoot, HiddenRunsGiveWayAndStayOtherwise) {
    const ClippedPaths clipped = straight();
    const Runs runs =
        runs_of({{0, -100, -50, 2}, {0, -50, 0}, {0, 0, 4, 1}, {0, 4, 10, 3}, {0, 40, 60}, {0, 60, 100, 1}});
    expect_same(overshoot(clipped, runs, everywhere(clipped, 5)), runs);
    expect_runs(overshoot(clipped, runs, everywhere(clipped, -5)),
                {{0, -100, -50, 2}, {0, -45, -5}, {0, 0, 4, 1}, {0, 4, 10, 3}, {0, 45, 55}, {0, 60, 100, 1}});
    expect_runs(overshoot(clipped, runs, everywhere(clipped, -25)),
                {{0, -100, -50, 2}, {0, 0, 4, 1}, {0, 4, 10, 3}, {0, 60, 100, 1}});
}

TEST(Overshoot, OfNothingIsTheIdentity) {
    const ClippedPaths clipped = of_all_kinds();
    std::mt19937 random(1);
    for (int k = 0; k < 10; ++k) {
        const Runs runs = random_runs(clipped, random);
        expect_same(overshoot(clipped, runs, everywhere(clipped, 0)), runs);
        expect_same(halo(clipped, runs, everywhere(clipped, 0)), runs);
        expect_same(close_gaps(clipped, runs, 0, everywhere(clipped, 0)), runs);
    }
}

TEST(Overshoot, GrowsWithItsAmountAndContinuously) {
    const ClippedPaths clipped = of_all_kinds();
    std::mt19937 random(2);
    const Runs runs = random_runs(clipped, random);
    Runs less = overshoot(clipped, runs, everywhere(clipped, -6.0f));
    const std::vector<float> amounts{-5.9f, -3.0f, -0.01f, 0.0f, 0.01f, 0.5f, 0.51f, 4.0f, 20.0f};
    double before = -6.0;
    for (float amount : amounts) {
        const Runs more = overshoot(clipped, runs, everywhere(clipped, amount));
        expect_sound(more);
        EXPECT_TRUE(holds(more, less)) << amount;
        // No end moves farther than the amount does; a run that appears has two.
        EXPECT_LE(visible_length(more) - visible_length(less), 2.0 * (amount - before) * runs.size() + 1e-6) << amount;
        less = more;
        before = amount;
    }
}

TEST(Overshoot, DoesNotSeeSegmentsNorAtlasRows) {
    ProjectOptions fine;
    fine.sample_step_px = 0.05;
    const ClippedPaths one = Wires({{at(70, 100), at(570, 100)}}).project(camera(), fine);
    const ClippedPaths many = Wires({divided(at(70, 100), at(570, 100), 113)}).project(camera(), fine);
    ASSERT_GT(one.samples, 4u * 2048u);
    Array<float> samples(one.samples, 0.0f);
    for (std::size_t i = 0; i < samples.size(); ++i) samples[i] = std::sin(0.003 * i) > -0.3 ? 1.0f : 0.0f;
    const Runs runs = runs_from_samples(one, samples);
    ASSERT_GT(runs.size(), 3u);
    for (float amount : {3.0f, 12.0f, -4.0f}) {
        const Runs a = overshoot(one, runs, everywhere(one, amount)),
                   b = overshoot(many, runs, everywhere(many, amount));
        ASSERT_EQ(a.size(), b.size());
        for (std::size_t r = 0; r < a.size(); ++r) {
            EXPECT_NEAR(a.start_px[r], b.start_px[r], 1e-3);
            EXPECT_NEAR(a.end_px[r], b.end_px[r], 1e-3);
        }
    }
}

TEST(Overshoot, OfARingDoesNotSeeItsSeam) {
    const ClippedPaths clipped = Wires({ring(320, 240, 100)}).project(camera());
    ASSERT_TRUE(clipped.closed[0]);
    const double first = clipped.arc_px[0], last = clipped.arc_px[last_of(clipped, 0)];
    const auto grown = [&](const std::vector<Part>& parts, float amount) {
        return overshoot(clipped, runs_of(parts), everywhere(clipped, amount));
    };
    expect_runs(grown({{0, first, last}}, 5), {{0, first, last}});
    expect_runs(grown({{0, first, last}}, -5), {{0, first, last}});
    for (const auto& parts : std::vector<std::vector<Part>>{{{0, first + 2, first + 20}},
                                                            {{0, last - 20, last}},
                                                            {{0, first, first + 10}, {0, last - 20, last}},
                                                            {{0, first + 4, last - 4}}})
        expect_runs(grown(parts, 5), parts);
    expect_runs(grown({{0, last - 20, last}}, -5), {{0, last - 15, last - 5}});
    expect_runs(grown({{0, first, first + 10}, {0, last - 20, last}}, -12), {{0, last - 8, last - 2}});
}

TEST(Overshoot, CrossesTheSeamOfARingThatTheFrameCuts) {
    const ClippedPaths clipped = Wires({ring(640, 240, 100, 16)}).project(camera());
    ASSERT_EQ(clipped.path.size(), 2u);
    const double seam0 = clipped.arc_px[0], cut0 = clipped.arc_px[last_of(clipped, 0)];
    const double cut1 = clipped.arc_px[first_of(clipped, 1)], seam1 = clipped.arc_px[last_of(clipped, 1)];
    const auto grown = [&](const std::vector<Part>& parts, float amount) {
        return overshoot(clipped, runs_of(parts), everywhere(clipped, amount));
    };
    expect_runs(grown({{0, seam0, seam0 + 10}, {1, seam1 - 6, seam1}}, 5),
                {{0, seam0, seam0 + 10}, {1, seam1 - 6, seam1}});
    expect_runs(grown({{0, seam0, seam0 + 10}, {1, seam1 - 4, seam1}}, -5), {{0, seam0 + 1, seam0 + 5}});
    expect_runs(grown({{0, seam0 + 2, cut0}}, 5), {{0, seam0 + 2, cut0}});
    expect_runs(grown({{0, seam0, cut0}, {1, cut1, seam1}}, -5), {{0, seam0, cut0}, {1, cut1, seam1}});
}

TEST(CloseGaps, DoesNotSeeTheSeamOfARing) {
    const ClippedPaths clipped = Wires({ring(320, 240, 100)}).project(camera());
    const double first = clipped.arc_px[0], last = clipped.arc_px[last_of(clipped, 0)];
    const auto closed = [&](const std::vector<Part>& parts) {
        return close_gaps(clipped, runs_of(parts), 3.0, everywhere(clipped, 4.0f));
    };
    expect_runs(closed({{0, first + 1, last - 1}}), {{0, first, last}});
    expect_runs(closed({{0, first + 1, 0}, {0, 20, last - 1}}), {{0, first, 0}, {0, 20, last}});
    expect_runs(closed({{0, first + 2, 0}, {0, 20, last - 2}}), {{0, first + 2, 0}, {0, 20, last - 2}});
    expect_runs(closed({{0, first, first + 1}, {0, last - 2, last}}), {});
    expect_runs(closed({{0, first, first + 2}, {0, last - 3, last}}), {{0, first, first + 2}, {0, last - 3, last}});
}

TEST(CloseGaps, SpecksAtTheEndsOfALineGoButNotAWholeLine) {
    const ClippedPaths line = straight();
    const double begin = line.arc_px[0], end = line.arc_px[1];
    const auto closed = [&](const std::vector<Part>& parts, double speck) {
        return close_gaps(line, runs_of(parts), 3.0, everywhere(line, 10.0f), speck);
    };
    EXPECT_EQ(closed({{0, begin, begin + 0.1}, {0, end - 0.8, end}}, 1.0).size(), 0u);
    const std::vector<Part> longer{{0, begin, begin + 1.1}, {0, end - 1.1, end}};
    expect_runs(closed({longer[0], {0, -50, -41}, longer[1]}, 1.0), longer);
    expect_runs(closed({{0, begin, end}}, 300.0), {{0, begin, end}});
    EXPECT_EQ(closed({{0, begin, end - 1.0}}, 300.0).size(), 0u);
}

TEST(CloseGaps, HiddenRunsGiveWay) {
    const ClippedPaths clipped = straight();
    const Runs runs =
        runs_of({{0, -100, -50}, {0, -50, -49, 1}, {0, -49, 0}, {0, 0, 50, 2}, {0, 50, 51}, {0, 51, 100, 1}});
    expect_runs(close_gaps(clipped, runs, 3.0, everywhere(clipped, 4.0f)),
                {{0, -100, 0}, {0, 0, 50, 2}, {0, 51, 100, 1}});
}

TEST(Filters, AreTheSameForAnyNumberOfThreads) {
    const ClippedPaths clipped = of_all_kinds();
    std::mt19937 random(3);
    const Runs runs = random_runs(clipped, random);
    const auto all = [&] {
        Runs result = close_gaps(clipped, runs, 2.0, everywhere(clipped, 2.0f));
        result = halo(clipped, result, everywhere(clipped, 3.0f));
        return overshoot(clipped, result, everywhere(clipped, 1.5f));
    };
    const Runs many = all();
    EXPECT_GT(many.size(), 100u);
    expect_sound(many);
    tbb::global_control one(tbb::global_control::max_allowed_parallelism, 1);
    expect_same(all(), many);
}

TEST(Filters, RefuseWhatDoesNotFit) {
    const ClippedPaths clipped = straight();
    const Runs runs = whole(clipped);
    const float nan = std::numeric_limits<float>::quiet_NaN();
    EXPECT_THROW(overshoot(clipped, runs, std::vector<float>{}), std::invalid_argument);
    EXPECT_THROW(overshoot(clipped, runs, std::vector<float>{nan}), std::invalid_argument);
    EXPECT_THROW(overshoot(clipped, runs_of({{7, 0, 1}}), std::vector<float>{1}), std::invalid_argument);
    EXPECT_THROW(halo(clipped, runs, std::vector<float>{}), std::invalid_argument);
    EXPECT_THROW(halo(clipped, runs, std::vector<float>{-1}), std::invalid_argument);
    EXPECT_THROW(halo(clipped, runs_of({{7, 0, 1}}), std::vector<float>{1}), std::invalid_argument);
    EXPECT_EQ(overshoot({}, {}, std::vector<float>{}).size() + halo({}, {}, std::vector<float>{}).size(), 0u);
}

TEST(Overshoot, MixesItsAmountAtEitherEnd) {
    const ClippedPaths clipped = straight();
    std::vector<float> mix(clipped.samples);
    for (std::size_t s = 0; s < mix.size(); ++s) mix[s] = (s + 0.5f) / mix.size();  // 0 at -100, 1 at 100
    const Runs runs = runs_of({{0, -50, 50}});
    const Runs shorter = overshoot(clipped, runs, everywhere(clipped, -4), everywhere(clipped, -20), mix);
    ASSERT_EQ(shorter.size(), 1u);
    EXPECT_NEAR(shorter.start_px[0], -50 + 8, 1e-3);
    EXPECT_NEAR(shorter.end_px[0], 50 - 16, 1e-3);
    const Runs whole_line = overshoot(clipped, whole(clipped), everywhere(clipped, 4), everywhere(clipped, 20), mix);
    EXPECT_NEAR(whole_line.start_px[0], -104, 0.2);
    EXPECT_NEAR(whole_line.end_px[0], 120, 0.2);
    expect_same(overshoot(clipped, runs, everywhere(clipped, 0), everywhere(clipped, 0), mix), runs);
}

TEST(Overshoot, MixesAcrossTheSeamOfAClosedLine) {
    const ClippedPaths clipped = Wires({ring(200, 200, 80)}).project(camera());
    const double half = clipped.arc_px[clipped.pieces.end(0) - 1];
    const std::vector<float> all(clipped.samples, 0.5f);
    // Visible across the seam.
    const Runs runs = runs_of({{0, -half, -half + 30}, {0, half - 30, half}});
    const Runs shorter = overshoot(clipped, runs, everywhere(clipped, 0), everywhere(clipped, -10), all);
    ASSERT_EQ(shorter.size(), 2u);
    EXPECT_NEAR(shorter.end_px[0], -half + 25, 1e-6);
    EXPECT_NEAR(shorter.start_px[1], half - 25, 1e-6);
}
