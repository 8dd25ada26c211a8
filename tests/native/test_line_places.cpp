// SPDX-License-Identifier: GPL-3.0-or-later
// Places on lines of the mesh are found again in other frames.
#include <gtest/gtest.h>

#include <fovea/elision/line_places.h>

#include "wires.h"

using namespace fovea;
using namespace fovea::draw;

namespace {

using Lines = std::vector<std::vector<dvec3>>;

const std::vector<dvec3> bent{{-0.6, 0.1, -1.0}, {0.0, 0.2, -1.4}, {0.6, 0.1, -1.0}},
    other{{-0.6, -0.1, -1.0}, {0.6, -0.1, -1.0}};

/// Lines of a mesh before a camera, each one run, wholly visible or wholly hidden.
struct Seen {
    wires::Wires lines;
    bool across_triangles = false;  ///< not along edges
    LinePlaces places;

    explicit Seen(const Lines& points, dmat4 to_world = dmat4(1.0), double step_px = 2.0, std::uint8_t hidden_by = 0)
        : lines(points, to_world) {
        tell(step_px, hidden_by);
    }
    void tell(double step_px = 2.0, std::uint8_t hidden_by = 0) {
        const View view = wires::camera();
        const ClippedPaths clipped = lines.project(view, {.sample_step_px = step_px});
        Runs runs;
        for (Index q = 0; q < clipped.path.size(); ++q)
            runs.push(q, clipped.arc_px[wires::first_of(clipped, q)], clipped.arc_px[wires::last_of(clipped, q)],
                      hidden_by);
        Paths paths = lines.paths;
        if (across_triangles) std::ranges::fill(paths.place, Index(1000));
        places = line_places(clipped, paths, lines.scene, runs, view.width, view.height);
    }
};

/// How many samples of a frame are found in another one.
std::size_t found(const Seen& now, const Seen& there, bool hidden = false) {
    const MatchedPlaces matched(now.places, there.places);
    return std::ranges::count_if(now.places.samples, [&](const auto& s) { return matched.at(s, hidden).has_value(); });
}

}  // namespace

TEST(LinePlaces, APlaceIsFoundBetweenTheSamplesAroundItWhereverItsObjectIs) {
    const dmat4 turned = glm::rotate(glm::translate(dmat4(1.0), dvec3(0.02, 0, 0.1)), 0.2, dvec3(0, 0, 1));
    const Seen now({bent}), there({bent}, turned, 3.3);
    const MatchedPlaces matched(now.places, there.places);
    ASSERT_GT(now.places.samples.size(), 200u);
    for (const LinePlaces::Sample& sample : now.places.samples) {
        const auto place = matched.at(sample, false);
        ASSERT_TRUE(place);
        const auto &before = there.places.samples[place->before], &after = there.places.samples[place->after];
        EXPECT_NEAR(glm::mix(before.arc, after.arc, place->share), sample.arc, before.reach) << sample.number;
        if (before.number != after.number) {
            EXPECT_NEAR(glm::mix(before.arc, after.arc, place->share), sample.arc, 1e-6);
        }
    }
}

TEST(LinePlaces, AChangeOfTopologyEndsTheMatch) {
    for (const bool across_triangles : {false, true}) {
        Seen one({bent}), two({bent, other});
        one.across_triangles = two.across_triangles = across_triangles;
        one.tell();
        two.tell();
        EXPECT_EQ(found(one, one), one.places.samples.size());
        EXPECT_EQ(found(two, two), two.places.samples.size());
        EXPECT_EQ(found(one, two) + found(two, one), 0u);
    }
}

TEST(LinePlaces, AnotherObjectOfTheSameMeshIsAnother) {
    Seen copy({bent});
    copy.lines.scene.placements[0].id = 7;
    copy.tell();
    EXPECT_EQ(found(Seen({bent}), copy), 0u);
}

TEST(LinePlaces, WhatTwoPathsClaimIsNowhere) {
    Seen twice({bent, other});
    std::ranges::fill(twice.lines.paths.place, Index(0));
    twice.tell();
    EXPECT_EQ(found(twice, twice), 0u);
}

TEST(LinePlaces, VisibleStretchesAndHiddenOnesAreFoundApart) {
    const Seen visible({bent}), hidden({bent}, dmat4(1.0), 2.0, 1);
    EXPECT_EQ(found(visible, hidden, false), 0u);
    EXPECT_EQ(found(visible, hidden, true), visible.places.samples.size());
}

TEST(LinePlaces, LinesOfTheViewHaveNone) {
    Seen seen({bent, other});
    seen.lines.paths.of_view = {1, 0};
    seen.tell();
    for (const Index path : seen.places.path) EXPECT_EQ(path, 1u);
    EXPECT_GT(seen.places.samples.size(), 100u);
}
