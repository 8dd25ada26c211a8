// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <fovea/visibility/depth.h>
#include <fovea/visibility/spine.h>

using namespace fovea;
using namespace fovea::draw;

namespace {

/// A path of three segments, bent, over a surface that covers the right half of 100 x 80 pixels.
struct Scene2 {
    ClippedPaths clipped;
    OwnSides sides;
    DepthBuffer depth;

    Scene2() {
        const std::vector<vec2> px{{10, 20}, {30, 20}, {30, 40}, {90, 40}};
        double arc = -50.0;
        for (std::size_t i = 0; i < px.size(); ++i) {
            if (i > 0) arc += glm::distance(px[i - 1], px[i]);
            clipped.px.push_back(px[i]);
            clipped.arc_px.push_back(arc);
            clipped.depth.push_back(0.5f);
            clipped.facet0.push_back(none);
            clipped.facet1.push_back(none);
            sides.steepness.push_back(0.0f);
            sides.inner.push_back(0);
        }
        clipped.pieces.offsets.push_back(4);
        depth.scale = 2;
        depth.width = 200;
        depth.height = 160;
        depth.texels.resize(200 * 160);
        for (int y = 0; y < 160; ++y)
            for (int x = 120; x < 200; ++x) depth.texels[y * 200 + x] = {0.9f, 0.0f, 0.0f, 0};
    }

    float at(float u, int probes = 9) const {
        return SpineTest(clipped, sides, depth, {.probes = probes}).visibility(0, u);
    }
};

}  // namespace

TEST(Spine, FindsThePlaceByArcLength) {
    const Scene2 scene;
    // x = 60 on the last segment is 70 px from the start, at u = 20.
    for (const float u : {-60.0f, -50.0f, -31.0f, -29.9f, -10.1f, 0.0f, 18.9f}) EXPECT_EQ(scene.at(u), 1.0f) << u;
    for (const float u : {21.1f, 40.0f, 50.0f, 60.0f}) EXPECT_EQ(scene.at(u), 0.0f) << u;
}

TEST(Spine, ProbesArePartsOfAPixel) {
    const Scene2 scene;
    float before = 1.0f;
    bool between = false;
    for (float u = 18.5f; u < 21.5f; u += 0.05f) {
        const float seen = scene.at(u, 16);
        EXPECT_LE(seen, before);
        between |= seen > 0.2f && seen < 0.8f;
        before = seen;
    }
    EXPECT_EQ(before, 0.0f);
    EXPECT_TRUE(between);
}

TEST(Spine, WholePiecesHaveWholeRuns) {
    const Scene2 scene;
    const Runs runs = whole_pieces(scene.clipped);
    ASSERT_EQ(runs.size(), 1u);
    EXPECT_EQ(runs.start_px[0], -50.0);
    EXPECT_EQ(runs.end_px[0], 50.0);
    EXPECT_EQ(whole_pieces(ClippedPaths()).size(), 0u);
}

TEST(Spine, KnowsWhichPiecesHaveSegments) {
    const Scene2 scene;
    const SpineTest spine(scene.clipped, scene.sides, scene.depth, {});
    EXPECT_TRUE(spine.has(0));
    EXPECT_FALSE(spine.has(1));
    EXPECT_THROW(SpineTest(scene.clipped, OwnSides(), scene.depth, {}), std::invalid_argument);
    EXPECT_THROW(SpineTest(scene.clipped, scene.sides, scene.depth, {.probes = 17}), std::invalid_argument);
}

TEST(Spine, TheTableHoldsEverySegment) {
    Scene2 scene;
    scene.sides.inner[1] = 1;
    scene.sides.steepness[2] = 0.25f;
    const Array<vec4> table = spine_table(scene.clipped, scene.sides);
    ASSERT_EQ(table.size(), 12u);
    EXPECT_EQ(table[3], vec4(30, 20, 0.5f, -30));
    EXPECT_EQ(table[4], vec4(30, 40, 0.5f, -10));
    EXPECT_EQ(table[5], vec4(-1, -1, -1, 0));
    EXPECT_EQ(table[8], vec4(-1, -1, 0.25f, 0));
}
