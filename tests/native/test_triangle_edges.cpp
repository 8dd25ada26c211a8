// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>
#include <random>

#include <fovea/visibility/triangle_edges.h>

using namespace fovea;

TEST(TriangleEdges, CodesKeepAnEdgeWithinTheirError) {
    std::mt19937 random(3);
    std::uniform_real_distribution<float> unit(-1.0f, 1.0f);
    for (int i = 0; i < 20000; ++i) {
        TexelEdge edge{unit(random) * 0.5f + 0.5f, unit(random), unit(random)};
        const float size = std::abs(edge.nx) + std::abs(edge.ny);
        edge.nx /= size;
        edge.ny /= size;
        const float any = 0.01f + std::abs(unit(random));  // edges come in any length
        const TexelEdge found = edge_of_code(edge_code({edge.inside * any, edge.nx * any, edge.ny * any}));
        EXPECT_NEAR(std::abs(found.nx) + std::abs(found.ny), 1.0f, 1e-6f);
        const vec2 off(unit(random), unit(random));
        EXPECT_NEAR(found.inside + found.nx * off.x + found.ny * off.y, edge.inside + edge.nx * off.x + edge.ny * off.y,
                    1.0f / 64.0f + 1.0f / 510.0f + 1e-5f);
    }
}

TEST(TriangleEdges, FarEdgesAndThoseWithoutDirectionCutNothingOff) {
    const int far = edge_code({3.0f, 0.6f, -0.4f}), nowhere = edge_code({0.2f, 0.0f, 0.0f});
    for (const float x : {-0.99f, 0.0f, 0.99f})
        for (const float y : {-0.99f, 0.0f, 0.99f}) EXPECT_TRUE(edges_hold(pack_edges(far, nowhere, far), {x, y}));
}

TEST(TriangleEdges, EachOfThreeCountsAndTheOrderDoesNot) {
    // x <= .5, y <= .25, x + y >= -.5.
    const int right = edge_code({0.5f, -1, 0}), top = edge_code({0.25f, 0, -1}), low = edge_code({0.5f, 1, 1});
    for (const vec2 packed : {pack_edges(right, top, low), pack_edges(low, right, top), pack_edges(top, low, right)}) {
        EXPECT_LT(packed.x, float(1 << 24));
        EXPECT_TRUE(edges_hold(packed, {0.0f, 0.0f}));
        EXPECT_TRUE(edges_hold(packed, {0.48f, 0.23f}));
        EXPECT_FALSE(edges_hold(packed, {0.52f, 0.0f}));
        EXPECT_FALSE(edges_hold(packed, {0.0f, 0.27f}));
        EXPECT_FALSE(edges_hold(packed, {-0.4f, -0.4f}));
    }
}
