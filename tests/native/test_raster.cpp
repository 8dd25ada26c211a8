// SPDX-License-Identifier: GPL-3.0-or-later
// The reference picture: every pixel once, fragments as the formula says, ink neither lost nor
// gained.
#include <gtest/gtest.h>
#include <random>

#include <fovea/raster/fixed_triangle.h>
#include <fovea/stroke/fragment.h>
#include <fovea/stroke/ink.h>

#include "stroke_fixture.h"

namespace fovea {
using namespace draw;
namespace {

using namespace stroke_fixture;

TEST(Triangle, FanAroundAPointCoversEveryPixelOnce) {
    std::mt19937 random(5);
    std::uniform_int_distribution<int> at(0, 64 * 4);
    for (int trial = 0; trial < 300; ++trial) {
        // Corners on quarters of pixels: many edges run through pixel centers.
        const vec2 center(at(random) / 4.0f, at(random) / 4.0f);
        const vec2 ring[4] = {{0.0f, 0.0f}, {64.0f, 0.0f}, {64.0f, 64.0f}, {0.0f, 64.0f}};
        std::vector<int> hits(64 * 64, 0);
        for (int k = 0; k < 4; ++k) {
            const vec2 next = ring[(k + 1) % 4];
            const FixedTriangle t =
                trial % 2 ? FixedTriangle(center, ring[k], next) : FixedTriangle(next, ring[k], center);
            const PixelBox box = intersect(t.box(), {0, 0, 64, 64});
            for (int y = box.y0; y < box.y1; ++y) {
                int x0 = box.x0, x1 = box.x1;
                if (!t.empty())
                    t.span(y, x0, x1);
                else
                    x1 = x0;
                for (int x = x0; x < x1; ++x) ++hits[y * 64 + x];
            }
        }
        for (const int h : hits) ASSERT_EQ(h, 1) << trial;
    }
}

TEST(Triangle, WithoutAreaOrFarAwayIsEmpty) {
    EXPECT_TRUE(FixedTriangle({1, 1}, {5, 5}, {9, 9}).empty());
    EXPECT_TRUE(FixedTriangle({1, 1}, {NAN, 5}, {9, 3}).empty());
    EXPECT_TRUE(FixedTriangle({1, 1}, {1e9f, 5}, {9, 3}).empty());
}

TEST(Raster, PictureDoesNotDependOnTiles) {
    // The same strokes moved by whole pixels, so that the borders between tiles fall elsewhere.
    std::mt19937 random(11);
    std::uniform_real_distribution<float> at(20.0f, 230.0f);
    std::vector<std::vector<vec2>> lines;
    for (int i = 0; i < 40; ++i) lines.push_back({{at(random), at(random)}, {at(random), at(random)}});
    const auto draw_at = [&](vec2 shift) {
        ClippedPaths clipped;
        for (const auto& line : lines) add_piece(clipped, {line[0] + shift, line[1] + shift});
        Runs runs = whole_runs(clipped);
        const Pen p = pen(5.0f, Cap::round, 0.5f);
        return picture(strokes_of(clipped, runs, p), p, 400, 400);
    };
    const auto a = draw_at({0.0f, 0.0f}), b = draw_at({37.0f, 90.0f});
    for (int y = 0; y < 250; ++y)
        for (int x = 0; x < 250; ++x)
            ASSERT_NEAR(a[y * 400 + x].a, b[(y + 90) * 400 + x + 37].a, 2e-3f) << x << " " << y;
}

TEST(Raster, LaterStrokesLieOverEarlierOnes) {
    ClippedPaths clipped;
    add_piece(clipped, {{10.0f, 32.0f}, {54.0f, 32.0f}});
    add_piece(clipped, {{32.0f, 10.0f}, {32.0f, 54.0f}});
    Pen pens[2] = {pen(8.0f), pen(8.0f, Cap::round, 0.5f)};
    pens[0].look.color = {1.0f, 0.0f, 0.0f};
    pens[1].look.color = {0.0f, 0.0f, 1.0f};
    const std::vector<Index> pen_of_run{0, 1};
    const Strokes strokes = tessellate(clipped, whole_runs(clipped), pen_of_run, {}, pens);
    const Array<vec4> image = rasterize(strokes, pens, {}, 64, 64);
    EXPECT_EQ(image[32 * 64 + 32], vec4(0.5f, 0.0f, 0.5f, 1.0f));
    EXPECT_EQ(image[32 * 64 + 15], vec4(1.0f, 0.0f, 0.0f, 1.0f));
    EXPECT_EQ(image[50 * 64 + 32], vec4(0.0f, 0.0f, 0.5f, 0.5f)) << "premultiplied";
    EXPECT_EQ(image[5 * 64 + 5], vec4(0.0f));
}

TEST(Raster, StrokesAcrossTheBorderAreCut) {
    const Pen p = pen(20.0f);
    const auto image = picture(strokes_of({{-500.0f, -300.0f}, {700.0f, 420.0f}}, p), p, 100, 60);
    EXPECT_GT(image[0].a, 0.99f);
    EXPECT_GT(image[59 * 100 + 99].a, 0.99f);
    EXPECT_EQ(image[59 * 100].a, 0.0f);
}

TEST(Raster, EmptyAndWrongInput) {
    const Pen p = pen(2.0f);
    EXPECT_EQ(area(picture(Strokes{}, p, 7, 5)), 0.0);
    EXPECT_THROW(picture(Strokes{}, p, 0, 5), std::invalid_argument);
    Pen textured = p;
    textured.texture = 2;
    EXPECT_THROW(picture(Strokes{}, textured, 7, 5), std::invalid_argument);
    Strokes wrong = strokes_of({{1.0f, 1.0f}, {5.0f, 1.0f}}, p);
    wrong.triangles[0].x = 999;
    EXPECT_THROW(picture(wrong, p, 7, 5), std::invalid_argument);
}

TEST(Raster, TextureRunsAlongTheStrokeFirstRowLeft) {
    // Left half of the way has ink, in every second half of a repetition.
    PenTexture texture{4, 2, {1.0f, 1.0f, 0.0f, 0.0f, 0.0f, 0.0f, 0.0f, 0.0f}};
    Pen p = pen(16.0f, Cap::butt);
    p.texture = 0;
    p.texture_length_px = 40.0f;
    const auto image = picture(strokes_of({{20.0f, 32.0f}, {180.0f, 32.0f}}, p), p, 200, 64, {&texture, 1});
    for (int x = 25; x < 175; ++x) {
        const double u = x + 0.5 - 100.0, phase = u / 40.0 - std::floor(u / 40.0);
        if (phase > 0.13 && phase < 0.37) {
            EXPECT_FLOAT_EQ(image[38 * 200 + x].a, 1.0f) << x;
        }
        if (phase > 0.63 && phase < 0.87) {
            EXPECT_FLOAT_EQ(image[38 * 200 + x].a, 0.0f) << x;
        }
        EXPECT_FLOAT_EQ(image[26 * 200 + x].a, 0.0f) << x;
    }
}

TEST(Raster, MinifiedTextureKeepsItsMeanInk) {
    PenTexture texture{512, 32, {}};
    std::mt19937 random(2);
    for (int i = 0; i < 512 * 32; ++i) texture.ink.push_back(float(random() % 2));
    double mean = 0.0;
    for (const float i : texture.ink) mean += i / texture.ink.size();
    Pen p = pen(3.0f, Cap::butt);
    p.texture = 0;
    p.texture_length_px = 10.0f;
    const auto image = picture(strokes_of({{10.0f, 30.0f}, {210.0f, 41.0f}}, p), p, 220, 80, {&texture, 1});
    const double full = std::hypot(200.0, 11.0) * 3.0;
    EXPECT_NEAR(area(image) / full, mean, 0.02);
    EXPECT_LT(largest_alpha(image), mean + 0.1) << "texels smaller than a pixel are averaged";
}

TEST(Ink, FittingKeepsTheMeanAndNeverEnlarges) {
    PenTexture texture{6, 4, {}};
    for (int i = 0; i < 24; ++i) texture.ink.push_back(float(i % 5) / 4.0f);
    for (const vec2 size : {vec2(3.0f, 2.0f), vec2(4.3f, 2.5f), vec2(0.2f, 0.1f), vec2(100.0f, 100.0f)}) {
        const PenTexture fitted = fit_texture(texture, size.x, size.y);
        double before = 0.0, after = 0.0;
        for (const float i : texture.ink) before += i / texture.ink.size();
        for (const float i : fitted.ink) after += i / fitted.ink.size();
        EXPECT_NEAR(before, after, 1e-6);
        EXPECT_EQ(fitted.width, std::min(6, std::max(1, int(std::ceil(size.x)))));
        EXPECT_EQ(fitted.height, std::min(4, std::max(1, int(std::ceil(size.y)))));
    }
    EXPECT_EQ(fit_texture(texture, 6.0f, 4.0f).ink, texture.ink);
    EXPECT_THROW(fit_texture(PenTexture{}, 4.0f, 4.0f), std::invalid_argument);
}

TEST(Fragment, ButtEndsAddUpToTheLengthOfTheRun) {
    for (const float length : {0.1f, 0.5f, 1.0f, 3.3f}) {
        double sum = 0.0;
        for (float u = -2.0f; u < 6.0f; u += 0.01f) sum += 0.01 * coverage(u, 0.0f, 0.0f, length, 2.0f, Cap::butt);
        EXPECT_NEAR(sum, length, 0.01);
    }
}

}  // namespace
}  // namespace fovea
