// SPDX-License-Identifier: GPL-3.0-or-later
// Visible runs that meet (runs/groups.h), and what is made of groups: tips removed, small figures thinned as a whole.
#include <fovea/elision/figures.h>
#include <fovea/runs/groups.h>

#include "elision_fixture.h"
#include "line_filters.h"

using namespace fovea;
using namespace fovea::draw;
using namespace fovea::line_filters;

namespace {

/// A corner of two lines, and a line apart.
const Wires corner({{at(100, 100), at(140, 100)}, {at(140, 100), at(140, 130)}, {at(200, 200), at(300, 200)}});
const std::vector<Index> one_object(3, 0);

ClippedPaths clipped_corner() { return corner.project(camera()); }

/// The last pixels of a line whose rest is hidden, and another line.
struct Tip {
    ClippedPaths clipped;
    Runs runs;

    Tip(double seen_px, dvec2 other) {
        clipped =
            Wires({{at(100, 100), at(200, 100)}, {at(other.x, other.y), at(other.x, other.y + 80)}}).project(camera());
        runs.push(0, clipped.last_arc(0) - seen_px, clipped.last_arc(0));
        runs.push(1, clipped.first_arc(1), clipped.last_arc(1));
    }
    std::size_t left() const { return without_tips(clipped, runs, std::vector<Index>(2, 0), 10.0, 4.0).size(); }
};

/// Two lines so far apart, and a more important one so far from them, as one figure of a size.
struct Pair {
    Sheet sheet;
    OwnBands own;

    Pair(float apart, float size_px, float third = 1000.0f, float largest_px = 80.0f) {
        for (const float y : {80.0f - third, 80.0f, 80.0f + apart}) sheet.line({{40.0f, y}, {120.0f, y}});
        own = sheet.own();
        const Groups groups{{0, 1, 1}, {80.0f, size_px}, {80.0f, 160.0f}, {0, 0}};
        mark_figures(groups, sheet.runs, sheet.ranks(), largest_px, own);
    }
    std::vector<float> scores(Index line) const { return sheet.of(line, sheet.scores(own)); }
};

}  // namespace

TEST(Groups, AreRunsThatMeetAtTheEndsOfTheirLines) {
    const ClippedPaths clipped = clipped_corner();
    const Groups groups = group_runs(clipped, whole(clipped), one_object, false);
    EXPECT_EQ(groups.of_run, (Array<Index>{0, 0, 1}));
    EXPECT_NEAR(groups.size_px[0], 40.0f, 0.01f);
    EXPECT_NEAR(groups.length_px[0], 70.0f, 0.01f);
    EXPECT_EQ(groups.hidden, (Array<std::uint8_t>{0, 0}));
    EXPECT_EQ(group_runs(clipped, whole(clipped), std::vector<Index>{0, 1, 0}, false).count(), 3u) << "two objects";
}

TEST(Groups, EndWhereASurfaceHidesALine) {
    const ClippedPaths clipped = clipped_corner();
    Runs runs;
    runs.push(0, clipped.first_arc(0), clipped.first_arc(0) + 10.0);
    runs.push(0, clipped.first_arc(0) + 10.0, clipped.last_arc(0) - 5.0, 1);
    runs.push(0, clipped.last_arc(0) - 5.0, clipped.last_arc(0));
    runs.push(1, clipped.first_arc(1), clipped.last_arc(1));
    const Groups apart = group_runs(clipped, runs, one_object, false);
    EXPECT_EQ(apart.of_run, (Array<Index>{0, none, 1, 1}));
    EXPECT_EQ(apart.hidden, (Array<std::uint8_t>{1, 1}));
    EXPECT_EQ(group_runs(clipped, runs, one_object, true).of_run, (Array<Index>{0, none, 0, 0})) << "whole paths";
}

TEST(Tips, GoWhereNothingTouchesTheirEnd) {
    EXPECT_EQ(Tip(6.0, {300, 100}).left(), 1u);
    EXPECT_EQ(Tip(12.0, {300, 100}).left(), 2u) << "a line";
    EXPECT_EQ(Tip(100.0, {300, 100}).left(), 2u) << "nothing of it is hidden";
}

TEST(Tips, StayWhereTheyFillAGapBetweenLines) {
    EXPECT_EQ(Tip(2.0, {201, 98}).left(), 2u) << "both ends touch the other line";
    EXPECT_EQ(Tip(6.0, {201, 98}).left(), 1u) << "its hidden end is farther away";
    EXPECT_EQ(Tip(6.0, {200, 100}).left(), 2u) << "it is joined to a longer line";
}

TEST(Figures, LinesOfASmallFigureTakeNothingFromEachOther) {
    EXPECT_LT(std::ranges::max(Pair(3.0f, 1000.0f).scores(2)), 0.7f);
    for (const Index line : {1u, 2u})
        for (const float score : Pair(3.0f, 12.0f).scores(line)) EXPECT_EQ(score, 1.0f);
}

TEST(Figures, ASmallFigureIsThinnedAsAWhole) {
    const Pair pair(3.0f, 12.0f, 4.0f);
    const std::vector<float> near = pair.scores(1), far = pair.scores(2);
    EXPECT_LT(near[0], 0.95f);
    for (const float score : near) EXPECT_EQ(score, near[0]);
    for (const float score : far) EXPECT_EQ(score, near[0]);
}

TEST(Figures, GrowUpSteadily) {
    float before = 1.0f;
    for (float size = 10.0f; size < 40.0f; size += 0.5f) {
        const float score = Pair(3.0f, size).scores(2)[20];
        EXPECT_LE(score, before + 1e-6f);
        EXPECT_GT(score, before - 0.06f);
        before = score;
    }
    EXPECT_EQ(before, Pair(3.0f, 1000.0f).scores(2)[20]);
}

TEST(Figures, AreNoLettersFromALargestSizeOnHoweverFewLinesShallBe) {
    EXPECT_EQ(Pair(3.0f, 10.0f, 1000.0f, 20.0f).scores(2)[20], 1.0f);
    EXPECT_EQ(Pair(3.0f, 20.0f, 1000.0f, 20.0f).scores(2), Pair(3.0f, 1000.0f).scores(2));
}

TEST(Figures, SmallOnesDoNotVanish) {
    const Pair pair(0.0f, 12.0f, 0.0f);
    const Array<float> scores = elision_scores(pair.own, crowding(pair.own, pair.sheet.buffer(pair.own)));
    const auto opacity = [&](float fade_from) {
        return pair.sheet.of(2, elision_opacities(pair.sheet.clipped, pair.own, scores, {.fade_from = fade_from}))[20];
    };
    EXPECT_EQ(opacity(0.9f), opacity(0.0f));
}
