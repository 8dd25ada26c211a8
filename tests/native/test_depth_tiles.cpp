// SPDX-License-Identifier: GPL-3.0-or-later
#include <glm/gtc/matrix_transform.hpp>
#include <gtest/gtest.h>
#include <random>

#include <fovea/visibility/depth.h>

using namespace fovea;
using namespace fovea::draw;

namespace {

View view_of(bool orthographic) {
    View view;
    view.width = 123;
    view.height = 77;
    view.orthographic = orthographic;
    view.near_clip = 0.1;
    view.far_clip = 50.0;
    view.view_to_clip = orthographic ? glm::ortho(-3.0, 3.0, -2.0, 2.0, 0.1, 50.0)
                                     : glm::perspective(0.8, 123.0 / 77.0, view.near_clip, view.far_clip);
    return view;
}

/// Triangles all over the view, some through the near plane.
struct Soup {
    std::vector<vec3> positions;
    std::vector<glm::uvec3> triangles;
    std::vector<Index> facets;

    Soup() {
        std::mt19937 random(3);
        std::uniform_real_distribution<float> x(-4.0f, 4.0f), z(-9.0f, 0.5f);
        for (Index t = 0; t < 80; ++t) {
            triangles.push_back(glm::uvec3(3 * t, 3 * t + 1, 3 * t + 2));
            facets.push_back(t);
            for (int k = 0; k < 3; ++k) positions.push_back({x(random), x(random), z(random)});
        }
    }
    std::vector<RasterMesh> meshes() const { return {{positions, triangles, facets, dmat4(1.0), 0}}; }
};

}  // namespace

TEST(DepthTiles, WhatIsSmallEnoughIsOneTile) {
    const View view = view_of(false);
    const DepthBuffer whole = depth_layout(view, {.scale = 2});
    const auto tiles = depth_tiles(view, {.scale = 2}, std::max(whole.width, whole.height), 5);
    ASSERT_EQ(tiles.size(), 1u);
    EXPECT_EQ(tiles[0].width, whole.width);
    EXPECT_EQ(tiles[0].border_y, whole.border_y);
    EXPECT_TRUE(tiles[0].decides({-1e6f, 1e6f}));
}

TEST(DepthTiles, EveryPlaceIsDecidedByOneTileThatShowsWhatIsAroundIt) {
    const View view = view_of(false);
    for (const int scale : {1, 2, 3}) {
        const DepthBuffer whole = depth_layout(view, {.scale = scale});
        const int overlap = 4;
        const auto tiles = depth_tiles(view, {.scale = scale}, 20 * scale, overlap);
        EXPECT_GT(tiles.size(), 20u);
        for (const DepthBuffer& tile : tiles) EXPECT_LE(std::max(tile.width, tile.height), 20 * scale);
        for (float y = -9.0f; y < 90.0f; y += 0.37f)
            for (float x = -9.0f; x < 140.0f; x += 0.37f) {
                int deciding = 0;
                for (const DepthBuffer& tile : tiles) {
                    if (!tile.decides({x, y})) continue;
                    ++deciding;
                    for (const vec2 around : {vec2(-overlap), vec2(overlap)}) {
                        const vec2 inside = glm::clamp(whole.to_texels(vec2(x, y) + around), vec2(0.5f),
                                                       vec2(whole.width, whole.height) - 0.5f);
                        const vec2 px = inside / float(scale) - vec2(whole.border_x, whole.border_y);
                        const vec2 texel = tile.to_texels(px);
                        EXPECT_TRUE(texel.x > 0 && texel.y > 0 && texel.x < tile.width && texel.y < tile.height);
                    }
                }
                EXPECT_EQ(deciding, 1);
            }
    }
}

TEST(DepthTiles, TexelsAreThoseOfTheWhole) {
    const Soup soup;
    for (const bool orthographic : {false, true})
        for (const int scale : {1, 3}) {
            const View view = view_of(orthographic);
            const DepthBuffer whole = draw_depth(depth_layout(view, {.scale = scale}), view, soup.meshes());
            std::size_t same = 0, all = 0, shown = 0;
            for (const DepthBuffer& layout : depth_tiles(view, {.scale = scale}, 40 * scale, 4)) {
                const int x0 = (whole.border_x - layout.border_x) * scale;
                const int y0 = (whole.border_y - layout.border_y) * scale;
                const DepthBuffer tile = draw_depth(layout, view, soup.meshes());
                for (int y = 0; y < tile.height; ++y)
                    for (int x = 0; x < tile.width; ++x, ++all) {
                        const DepthTexel &a = tile.at(x, y), &b = whole.at(x0 + x, y0 + y);
                        shown += b.facet != none;
                        same += a.facet == b.facet && std::abs(a.depth - b.depth) <= 2e-6f * std::abs(b.depth) + 1e-7f;
                    }
            }
            EXPECT_GT(shown, all / 4);
            EXPECT_GE(same + 2, all) << orthographic << " " << scale;  // a center may lie on an edge
        }
}

TEST(DepthTiles, ATileNeedsACore) {
    EXPECT_THROW(depth_tiles(view_of(false), {.scale = 2}, 20, 5), std::invalid_argument);
}
