// SPDX-License-Identifier: GPL-3.0-or-later
// What is seen of lines of the mesh in other frames is found at the same places of them.
#include <gtest/gtest.h>

#include <fovea/elision/seen_in_time.h>
#include <fovea/project/piece_arcs.h>

#include "wires.h"

using namespace fovea;
using namespace fovea::draw;

namespace {

using Lines = std::vector<std::vector<dvec3>>;

const std::vector<dvec3> bent{{-0.5, 0.0, -1.0}, {0.0, 0.0, -1.0}, {0.5, 0.0, -1.5}},
    other{{-0.5, -0.2, -1.0}, {0.5, -0.2, -1.0}};

/// Lines of a mesh before a camera, of which each is seen up to a length in space.
struct Seen {
    wires::Wires lines;
    ClippedPaths clipped;
    Runs runs;

    explicit Seen(const Lines& points, double until, dmat4 to_world = dmat4(1.0), bool backwards = false)
        : lines(points, to_world) {
        if (backwards) std::ranges::fill(lines.paths.edge_t, 1.0f);
        clipped = lines.project(wires::camera(), {.sample_step_px = 2.0});
        for (Index q = 0; q < clipped.path.size(); ++q)
            runs.push(q, clipped.first_arc(q), project::PieceArcs(clipped, lines.paths, q).in_image(until));
    }
    SeenLines told() const {
        const auto of_view =
            std::make_shared<ViewLines>(view_lines(clipped, lines.paths, lines.scene, wires::camera()));
        return seen_lines(clipped, lines.paths, lines.scene, runs, of_view);
    }
};

/// The ramps of the first path, of a frame with these around it.
std::vector<Ramp> ramps_of(const Seen& now, const std::vector<std::pair<int, const Seen*>>& others, int frames) {
    std::vector<SeenNear> near;
    for (const auto& [away, seen] : others) near.emplace_back(away, std::make_shared<SeenLines>(seen->told()));
    const SeenLines told = now.told();
    return SeenInTime(now.lines.paths, told, near, frames).ramps()[0];
}

void expect_ramp(const std::vector<Ramp>& ramps, double from, double to) {
    ASSERT_EQ(ramps.size(), 4u);
    EXPECT_NEAR(ramps[1].from, from, 1e-5);
    EXPECT_NEAR(ramps[2].to, to, 1e-5);
    EXPECT_NEAR(ramps[0].at_to, 1.0, 1e-5);
    EXPECT_NEAR(ramps[1].at_to, 0.5, 1e-5);
    EXPECT_NEAR(ramps[3].at_from, 0.0, 1e-5);
}

}  // namespace

TEST(SeenInTime, PlacesAreFoundWhereverTheObjectIsAlsoAcrossTheEdgesOfAPath) {
    const dmat4 turned = glm::rotate(glm::translate(dmat4(1.0), dvec3(0.02, 0.1, -0.3)), 0.3, dvec3(0, 1, 0));
    const Seen before({bent}, 0.3, turned), now({bent}, 0.5), after({bent}, 0.7, glm::inverse(turned));
    expect_ramp(ramps_of(now, {{-1, &before}, {1, &after}}, 1), 0.3, 0.7);
}

TEST(SeenInTime, PlacesInPixelsAreThoseInSpaceAndBack) {
    const Seen seen({bent}, 0.6);
    const project::PieceArcs arcs(seen.clipped, seen.lines.paths, 0);
    const double length = seen.lines.paths.arc_obj.back();
    for (double arc = 0.0; arc < length; arc += 0.03) EXPECT_NEAR(arcs.in_space(arcs.in_image(arc)), arc, 1e-6);
    EXPECT_NEAR(arcs.in_space(-1e6), 0.0, 1e-6);
    EXPECT_NEAR(arcs.in_image(2 * length), seen.clipped.last_arc(0), 1e-6);
}

TEST(SeenInTime, APathThatGoesTheOtherWayHasTheSamePlaces) {
    const std::vector<dvec3> line{other[0], other[1]}, back{other[1], other[0]};
    const Seen now({line}, 0.5);
    // Seen from its other end, of 1 unit in all; its edge has the same first vertex.
    Seen before({back}, 1.0, dmat4(1.0), true);
    before.lines.scene = now.lines.scene;
    before.runs = {};
    before.runs.push(0, project::PieceArcs(before.clipped, before.lines.paths, 0).in_image(0.7),
                     before.clipped.last_arc(0));
    const Seen after({line}, 0.7);
    expect_ramp(ramps_of(now, {{-1, &before}, {1, &after}}, 1), 0.3, 0.7);
}

TEST(SeenInTime, WhatIsNotFoundThereCountsAsInTheNextFrame) {
    const Seen now({bent}, 0.5), before({bent}, 0.3), two({bent, other}, 1.0);
    const auto one_sided = ramps_of(now, {{-1, &before}}, 1);
    ASSERT_EQ(one_sided.size(), 3u);
    EXPECT_NEAR(one_sided[1].at_from, 1.0, 1e-5);
    EXPECT_NEAR(one_sided[1].at_to, 0.5, 1e-5);
    // A mesh with other edges is another one; beyond it the frame before it goes on.
    EXPECT_TRUE(ramps_of(now, {{-1, &two}, {1, &two}}, 1).empty());
    const auto farther = ramps_of(now, {{-2, &two}, {-1, &before}}, 2);
    ASSERT_EQ(farther.size(), 3u);
    EXPECT_NEAR(farther[1].at_from, 0.75, 1e-5);
    EXPECT_NEAR(farther[1].at_to, 0.5, 1e-5);
}

TEST(SeenInTime, WhatIsOutsideOfAPictureIsNotHiddenThere) {
    const Seen now({bent}, 2.0), left({bent}, 2.0, glm::translate(dmat4(1.0), dvec3(-5.0, 0.0, 0.0)));
    const Seen partly({bent}, 2.0, glm::translate(dmat4(1.0), dvec3(-0.8, 0.0, 0.0)));
    ASSERT_LT(partly.told().stretches.values[0].to - partly.told().stretches.values[0].from, 1.0);
    EXPECT_TRUE(ramps_of(now, {{-1, &left}, {1, &partly}}, 1).empty());
}

TEST(SeenInTime, HiddenRunsStayWhereNothingIsSeenNow) {
    const Seen now({other}, 0.5), after({other}, 0.7), before({other}, 0.3);
    const Runs all = with_hidden(now.clipped, now.runs, now.lines.paths.placement);
    const SeenLines told = now.told();
    const std::vector<SeenNear> near{{-1, std::make_shared<SeenLines>(before.told())},
                                     {1, std::make_shared<SeenLines>(after.told())}};
    const auto ramps = SeenInTime(now.lines.paths, told, near, 1).ramps();
    const project::PieceArcs arcs(now.clipped, now.lines.paths, 0);
    for (const float least : {0.0f, 0.5f, 0.75f}) {
        const Runs found = seen_runs(now.clipped, now.lines.paths, all, ramps, least);
        ASSERT_EQ(found.size(), 2u);
        EXPECT_EQ(found.invisibility[0], 0);
        EXPECT_EQ(found.invisibility[1], 1);
        EXPECT_NEAR(found.start_px[1], std::max(found.end_px[0], now.runs.end_px[0]), 1e-9);
        EXPECT_NEAR(arcs.in_space(found.end_px[0]), 0.7 - 0.4 * least, 1e-5);
    }
    const Array<float> seen = seen_at_samples(now.clipped, now.lines.paths, ramps);
    EXPECT_EQ(seen.front(), 1.0f);
    EXPECT_EQ(seen.back(), 0.0f);
}

TEST(SeenInTime, RefusesFramesThatAreNotNear) {
    const Seen now({bent}, 0.5);
    EXPECT_THROW(ramps_of(now, {{0, &now}}, 1), std::invalid_argument);
    EXPECT_THROW(ramps_of(now, {{-2, &now}}, 1), std::invalid_argument);
}
