// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <gtest/gtest.h>
#include <random>
#include <tbb/global_control.h>

#include <fovea/visibility/item_buffer.h>

using namespace fovea;
using namespace fovea::draw;

namespace {

/// Lines over nothing: 100 x 80 pixels, `scale` texels to one, no border.
struct Paper {
    ClippedPaths clipped;
    DepthBuffer depth;

    explicit Paper(int scale = 1) {
        depth.scale = scale;
        depth.width = 100 * scale;
        depth.height = 80 * scale;
        depth.texels.resize(std::size_t(depth.width) * depth.height);
    }

    /// A surface over the texels right of x px: depth at the middle of the paper and slopes.
    void cover(float from_px, float at_middle, float ddx, float ddy) {
        for (int y = 0; y < depth.height; ++y)
            for (int x = 0; x < depth.width; ++x) {
                const vec2 px = (vec2(x, y) + 0.5f) / float(depth.scale);
                if (px.x < from_px) continue;
                const float d = at_middle + ddx * (px.x - 50.0f) + ddy * (px.y - 40.0f);
                depth.texels[std::size_t(y) * depth.width + x] = {d, ddx, ddy, 0};
            }
    }

    void line(vec2 from, vec2 to, float depth_from, float depth_to) {
        const Index count = Index(std::ceil(glm::distance(from, to) / 2.0f));
        for (int end = 0; end < 2; ++end) {
            clipped.px.push_back(end ? to : from);
            clipped.depth.push_back(end ? depth_to : depth_from);
            clipped.sample_start.push_back(clipped.samples + (end ? count : 0));
            clipped.sample_count.push_back(end ? 0 : count);
        }
        clipped.samples += count;
        clipped.pieces.offsets.push_back(Index(clipped.px.size()));
    }

    Array<float> visibility(int layers = 1) const { return item_visibility(clipped, depth, {.layers = layers}); }
    double share(const Array<float>& values, Index q) const {
        double sum = 0.0;
        for (Index j = 0; j < clipped.sample_count[2 * q]; ++j) sum += values[clipped.sample_start[2 * q] + j];
        return sum / clipped.sample_count[2 * q];
    }
};

}  // namespace

TEST(ItemBuffer, ALineAloneIsSeenAndOneTexelWide) {
    for (const int scale : {1, 3})
        for (int k = 0; k < 24; ++k) {
            Paper paper(scale);
            const float angle = float(k) * 0.2618f + 0.01f;
            const vec2 way = 30.0f * vec2(std::cos(angle), std::sin(angle)), middle(50.3f, 40.2f);
            paper.line(middle - way, middle + way, 0.4f, 0.5f);
            EXPECT_EQ(paper.share(paper.visibility(), 0), 1.0) << scale << " " << k;
            const ItemBuffer buffer = draw_items(paper.clipped, paper.depth, {});
            const double longer = 2.0 * scale * std::max(std::abs(way.x), std::abs(way.y));
            EXPECT_NEAR(double(std::ranges::count(buffer.items, 1u)), longer, 1.01);
        }
}

TEST(ItemBuffer, OnItsOwnLeaningSurfaceALineIsSeenAndBehindItHidden) {
    for (const float slope : {0.0f, 0.001f, 0.01f, -0.02f})
        for (const int scale : {1, 3}) {
            Paper paper(scale);
            paper.cover(0.0f, 0.5f, slope, 0.3f * slope);
            const auto on = [&](vec2 px) { return 0.5f + slope * (px.x - 50.0f) + 0.3f * slope * (px.y - 40.0f); };
            const vec2 a(40.2f, 20.7f), b(61.9f, 55.1f);
            const float behind = 3.0f * std::abs(slope) + 1e-4f;
            paper.line(a, b, on(a), on(b));
            paper.line(a, b, on(a) - behind, on(b) - behind);
            const Array<float> values = paper.visibility(3);
            EXPECT_EQ(paper.share(values, 0), 1.0) << slope;
            EXPECT_EQ(paper.share(values, 1), 0.0) << slope;
        }
}

TEST(ItemBuffer, BehindAnEdgeALineEndsWithinATexel) {
    Paper paper(3);
    paper.cover(57.0f, 0.9f, 0.0f, 0.0f);
    paper.line({20.0f, 30.5f}, {90.0f, 30.5f}, 0.5f, 0.5f);
    const Array<float> values = paper.visibility();
    for (Index j = 0; j < 35; ++j) {
        const float x = 20.0f + 2.0f * (float(j) + 0.5f);
        if (std::abs(x - 57.0f) > 1.4f) {
            EXPECT_EQ(values[paper.clipped.sample_start[0] + j], x < 57.0f ? 1.0f : 0.0f) << x;
        }
    }
}

TEST(ItemBuffer, OfLinesInOneTexelAsManyAreSeenAsThereAreLayers) {
    Paper paper;
    for (int q = 0; q < 4; ++q) paper.line({20.0f, 30.5f}, {80.0f, 30.5f}, 0.2f + 0.1f * q, 0.2f + 0.1f * q);
    for (const int layers : {1, 2, 3}) {
        const Array<float> values = paper.visibility(layers);
        for (Index q = 0; q < 4; ++q) EXPECT_EQ(paper.share(values, q), int(q) >= 4 - layers ? 1.0 : 0.0);
    }
}

TEST(ItemBuffer, ALineIsThereOnceHoweverOftenItComesBy) {
    Paper paper;
    paper.line({20.0f, 30.5f}, {80.0f, 30.5f}, 0.3f, 0.3f);
    paper.line({20.0f, 30.5f}, {80.0f, 30.5f}, 0.5f, 0.5f);
    // The nearer piece runs back over itself.
    const Index last = Index(paper.clipped.px.size());
    paper.clipped.px.push_back({20.0f, 30.5f});
    paper.clipped.depth.push_back(0.4f);
    paper.clipped.sample_start.push_back(paper.clipped.sample_start[last - 1]);
    paper.clipped.sample_count.push_back(0);
    ++paper.clipped.pieces.offsets.back();
    EXPECT_EQ(paper.share(paper.visibility(2), 0), 1.0);
    EXPECT_EQ(paper.share(paper.visibility(1), 0), 0.0);
}

TEST(ItemBuffer, TheSameForAnyNumberOfThreads) {
    Paper paper(3);
    paper.cover(57.0f, 0.5f, 0.001f, 0.0f);
    std::mt19937 random(5);
    std::uniform_real_distribution<float> x(-10.0f, 110.0f), y(-10.0f, 90.0f), d(0.4f, 0.6f);
    for (int q = 0; q < 400; ++q) paper.line({x(random), y(random)}, {x(random), y(random)}, d(random), d(random));
    const Array<float> many = paper.visibility(3);
    tbb::global_control one(tbb::global_control::max_allowed_parallelism, 1);
    EXPECT_EQ(many, paper.visibility(3));
}

TEST(ItemBuffer, RefusesWhatItCannotDraw) {
    Paper paper;
    EXPECT_THROW(paper.visibility(0), std::invalid_argument);
    EXPECT_THROW(paper.visibility(4), std::invalid_argument);
    EXPECT_THROW(item_visibility(paper.clipped, DepthBuffer(), {}), std::invalid_argument);
}
