// SPDX-License-Identifier: GPL-3.0-or-later
// Folds taken out of contours (runs/join_folds.h).
#include <fovea/runs/join_folds.h>

#include "line_filters.h"

using namespace fovea;
using namespace fovea::draw;
using namespace fovea::line_filters;

namespace {

constexpr double fold_px = 30.0, near_px = 2.0, spur_px = 10.0;

/// A line along bends, given in pixels.
ClippedPaths bent(const std::vector<dvec2>& bends) {
    std::vector<dvec3> line;
    for (const dvec2& bend : bends) line.push_back(at(bend.x, bend.y));
    return project_line(line, camera());
}

Unfolded joined(const ClippedPaths& clipped, const Runs& visible, std::uint8_t of_view = 1) {
    return join_folds(clipped, visible, std::vector<std::uint8_t>{of_view}, fold_px, near_px, spur_px);
}

/// Runs between distances from the start of the only piece.
Runs seen(const ClippedPaths& clipped, const std::vector<dvec2>& parts) {
    Runs runs;
    for (const dvec2& part : parts) runs.push(0, clipped.first_arc(0) + part.x, clipped.first_arc(0) + part.y);
    return runs;
}

/// Goes right for 100 px, back for 20 px half a pixel below, and right again for 80 px; the way back is hidden.
const std::vector<dvec2> folded{{100, 100}, {200, 100}, {180, 100.5}, {260, 101}};
const double way_back = glm::length(dvec2(20, 0.5)), way_on = glm::length(dvec2(80, 0.5));
const std::vector<dvec2> around_fold{{0, 100}, {100 + way_back, 100 + way_back + way_on}};

}  // namespace

TEST(JoinFolds, MakeOneRunOfAContourThatDoublesBack) {
    const ClippedPaths clipped = bent(folded);
    const Unfolded found = joined(clipped, seen(clipped, around_fold));
    ASSERT_EQ(found.runs.size(), 1u);
    EXPECT_NEAR(found.runs.start_px[0], found.clipped.first_arc(0), 1e-3);
    EXPECT_NEAR(found.runs.end_px[0], found.clipped.last_arc(0), 1e-3);
    EXPECT_NEAR(found.clipped.last_arc(0) - found.clipped.first_arc(0), 160.0, 1.0);
    double before = 0.0;
    for (double arc = found.clipped.first_arc(0); arc < found.clipped.last_arc(0); arc += 1.0) {
        const vec2 px = found.clipped.place_px(0, arc);
        EXPECT_GE(px.x, before) << "it goes on to the right";
        EXPECT_NEAR(px.y, 100.5, 0.6);
        before = px.x;
    }
}

TEST(JoinFolds, KeepTheSamplesOfWhatIsLeft) {
    const ClippedPaths clipped = bent(folded);
    const Unfolded found = joined(clipped, seen(clipped, around_fold));
    ASSERT_LT(found.clipped.samples, clipped.samples);
    ASSERT_EQ(found.sample.size(), found.clipped.samples);
    const auto places = [](const ClippedPaths& of) {
        std::vector<vec2> all;
        for (Index i = 0; i < of.px.size(); ++i)
            for (Index j = 0; j < of.sample_count[i]; ++j)
                all.push_back(glm::mix(of.px[i], of.px[i + 1], (float(j) + 0.5f) / float(of.sample_count[i])));
        return all;
    };
    const std::vector<vec2> before = places(clipped), after = places(found.clipped);
    ASSERT_EQ(after.size(), found.clipped.samples);
    for (std::size_t s = 0; s < after.size(); ++s)
        EXPECT_LT(glm::distance(after[s], before[found.sample[s]]), 2.0f) << s;
}

TEST(JoinFolds, LeaveWhatIsNoContourAsItIs) {
    const ClippedPaths clipped = bent(folded);
    const Unfolded found = joined(clipped, seen(clipped, around_fold), 0);
    EXPECT_EQ(found.runs.start_px, seen(clipped, around_fold).start_px);
    EXPECT_EQ(found.clipped.px, clipped.px);
    EXPECT_EQ(found.clipped.arc_px, clipped.arc_px);
    EXPECT_EQ(found.clipped.sample_start, clipped.sample_start);
}

TEST(JoinFolds, DoNotBridgeAGap) {
    // Ten pixels of a straight line are hidden; and a fold of which the second part begins four pixels aside.
    const ClippedPaths straight = bent({{100, 100}, {260, 100}});
    EXPECT_EQ(joined(straight, seen(straight, {{0, 80}, {90, 160}})).runs.size(), 2u);
    const ClippedPaths aside = bent({{100, 100}, {200, 100}, {180, 104}, {260, 104}});
    const double back = glm::length(dvec2(20, 4));
    EXPECT_EQ(joined(aside, seen(aside, {{0, 100}, {100 + back, 180 + back}})).runs.size(), 2u);
}

TEST(JoinFolds, DoNotTurnBackWhereBothSidesOfATipAreSeen) {
    // A thin tip: out and back again, a pixel apart; its end is hidden. Nothing of it is cut off.
    const ClippedPaths tip = bent({{100, 100}, {200, 100}, {201, 100.5}, {200, 101}, {100, 101}});
    const double end = 2.0 * glm::length(dvec2(1, 0.5));
    const Unfolded found = joined(tip, seen(tip, {{0, 100}, {100 + end, 200 + end}}));
    EXPECT_GT(found.clipped.last_arc(0) - found.clipped.first_arc(0), 199.0);
}

TEST(JoinFolds, PassOverASpurBetweenTwoPartsOfAnOutline) {
    // On its way back the line is seen for four pixels, three pixels below the outline.
    const ClippedPaths clipped = bent({{100, 100}, {200, 100}, {196, 103.5}, {192, 103.5}, {190, 100.5}, {260, 100.5}});
    const double down = glm::length(dvec2(4, 3.5)), up = glm::length(dvec2(2, 3));
    const double spur = 100 + down, on = spur + 4 + up;
    const Unfolded found = joined(clipped, seen(clipped, {{0, 100}, {spur, spur + 4}, {on, on + 70}}));
    ASSERT_EQ(found.runs.size(), 1u);
    for (const vec2& px : found.clipped.px) EXPECT_LT(px.y, 102.0f);
}

TEST(JoinFolds, KeepWhatLeadsAway) {
    // Seen for 40 px to the left and 15 px up; back hidden, and seen again to the right from half a pixel beside.
    const ClippedPaths clipped = bent({{140, 100}, {100, 100}, {100, 115}, {100.5, 100.5}, {180, 100.5}});
    const double back = glm::length(dvec2(0.5, 14.5));
    const Unfolded found = joined(clipped, seen(clipped, {{0, 55}, {55 + back, 55 + back + 79.5}}));
    EXPECT_GT(found.clipped.last_arc(0) - found.clipped.first_arc(0), 130.0);
    float highest = 0.0f;
    for (const vec2& px : found.clipped.px) highest = std::max(highest, px.y);
    EXPECT_NEAR(highest, 115.0f, 0.5f);
}

TEST(JoinFolds, ZigzagsBecomeOneRun) {
    // Ten times ahead by 20 px and back by 8 px.
    std::vector<dvec2> bends{{100, 100}}, parts;
    double arc = 0.0;
    for (int k = 0; k < 10; ++k) {
        bends.push_back(bends.back() + dvec2(20, 0.3));
        parts.push_back({arc, arc + glm::length(dvec2(20, 0.3))});
        arc = parts.back().y + 8.0;
        bends.push_back(bends.back() - dvec2(8, 0));
    }
    const ClippedPaths clipped = bent(bends);
    const Unfolded found = joined(clipped, seen(clipped, parts));
    ASSERT_EQ(found.runs.size(), 1u);
    EXPECT_NEAR(found.runs.end_px[0] - found.runs.start_px[0], 10 * 12 + 8, 2.0);
}

TEST(JoinFolds, LeaveASmallRingOfWhichHalfIsSeen) {
    // Both visible parts begin or end at its seam, where they are closest.
    std::vector<dvec2> ring;
    for (int k = 0; k <= 24; ++k)
        ring.push_back(dvec2(150, 150) + 8.0 * dvec2(std::cos(k * 0.2618), std::sin(k * 0.2618)));
    ring.back() = ring.front();
    const ClippedPaths clipped = bent(ring);
    ASSERT_TRUE(clipped.closed[0]);
    const double around = clipped.last_arc(0) - clipped.first_arc(0);
    const Unfolded found = joined(clipped, seen(clipped, {{0, around / 4}, {around * 3 / 4, around}}));
    EXPECT_EQ(found.runs.size(), 2u);
    EXPECT_EQ(found.clipped.samples, clipped.samples);
}

TEST(JoinFolds, RefuseWhatDoesNotFit) {
    const ClippedPaths clipped = bent(folded);
    EXPECT_THROW(join_folds(clipped, Runs(), {}, fold_px, near_px, spur_px), std::invalid_argument);
}
