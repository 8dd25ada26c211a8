// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>
#include <limits>
#include <random>

#include <fovea/visibility/triangle_edges.h>

using namespace fovea;
using namespace fovea::draw;

namespace {

formulas::Edges formula;

int code(float inside, float x, float y) { return formula.edge_code_of(inside, {x, y}); }

}  // namespace

TEST(TriangleEdges, CodesKeepAnEdgeWithinTheirError) {
    std::mt19937 random(3);
    std::uniform_real_distribution<float> unit(-1.0f, 1.0f);
    for (int i = 0; i < 20000; ++i) {
        vec3 edge{unit(random) * 0.5f + 0.5f, unit(random), unit(random)};
        const float size = std::abs(edge.y) + std::abs(edge.z);
        edge.y /= size;
        edge.z /= size;
        const float any = 0.01f + std::abs(unit(random));  // edges come in any length
        const vec3 found = formula.edge_of_code(code(edge.x * any, edge.y * any, edge.z * any));
        EXPECT_NEAR(std::abs(found.y) + std::abs(found.z), 1.0f, 1e-6f);
        const vec2 off{unit(random), unit(random)};
        EXPECT_NEAR(found.x + found.y * off.x + found.z * off.y, edge.x + edge.y * off.x + edge.z * off.y,
                    1.0f / 64.0f + 1.0f / 510.0f + 1e-5f);
    }
}

TEST(TriangleEdges, FarEdgesAndThoseWithoutDirectionCutNothingOff) {
    const int far = code(3.0f, 0.6f, -0.4f), nowhere = code(0.2f, 0.0f, 0.0f);
    for (const float x : {-0.99f, 0.0f, 0.99f})
        for (const float y : {-0.99f, 0.0f, 0.99f})
            EXPECT_TRUE(formula.packed_edges_hold(formula.pack_edges(far, nowhere, far), {x, y}));
}

TEST(TriangleEdges, EdgesSteeperThanNumbersCountCutNothingOff) {
    constexpr float inf = std::numeric_limits<float>::infinity(), most = std::numeric_limits<float>::max();
    for (const vec2 slope : {vec2(inf, 0), vec2(-inf, inf), vec2(most, most), vec2(0, -most)})
        EXPECT_EQ(code(1.0f, slope.x, slope.y), code(1.0f, 0.0f, 0.0f));
}

TEST(TriangleEdges, EachOfThreeCountsAndTheOrderDoesNot) {
    // x <= .5, y <= .25, x + y >= -.5.
    const int right = code(0.5f, -1, 0), top = code(0.25f, 0, -1), low = code(0.5f, 1, 1);
    for (const vec2 packed : {formula.pack_edges(right, top, low), formula.pack_edges(low, right, top),
                              formula.pack_edges(top, low, right)}) {
        EXPECT_LT(packed.x, float(1 << 24));
        EXPECT_TRUE(formula.packed_edges_hold(packed, {0.0f, 0.0f}));
        EXPECT_TRUE(formula.packed_edges_hold(packed, {0.48f, 0.23f}));
        EXPECT_FALSE(formula.packed_edges_hold(packed, {0.52f, 0.0f}));
        EXPECT_FALSE(formula.packed_edges_hold(packed, {0.0f, 0.27f}));
        EXPECT_FALSE(formula.packed_edges_hold(packed, {-0.4f, -0.4f}));
    }
}
