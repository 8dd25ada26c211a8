// SPDX-License-Identifier: GPL-3.0-or-later
// Focus by distance from points, per sample and per pixel.
#include <gtest/gtest.h>
#include <limits>

#include <fovea/focus/focus.h>

namespace fovea {
using namespace draw;
namespace {

constexpr float nan = std::numeric_limits<float>::quiet_NaN();

TEST(Focus, IsZeroNearAPointAndOneFarFromIt) {
    const Focus focus{FocusSpace::image, {{{100, 50, 0}, 10, 30}}};
    EXPECT_EQ(focus({100, 50}, {}), 0.0f);
    EXPECT_EQ(focus({110, 50}, {}), 0.0f);
    EXPECT_FLOAT_EQ(focus({100, 70}, {}), 0.5f);
    EXPECT_EQ(focus({100, 81}, {}), 1.0f);
    EXPECT_EQ(focus({nan, 0}, {}), 1.0f);
}

TEST(Focus, FallsOffRadiallyInTheScene) {
    const Focus focus{FocusSpace::scene, {{{1, 2, -3}, 1, 3}}};
    EXPECT_FLOAT_EQ(focus({}, {1, 2, -5}), 0.5f);
    EXPECT_FLOAT_EQ(focus({}, {3, 2, -3}), 0.5f);
}

TEST(Focus, WithoutPointsAllIsInFocus) { EXPECT_EQ(Focus{}({3, 4}, {1, 2, 3}), 0.0f); }

TEST(Focus, EqualRadiiAreAStep) {
    const Focus focus{FocusSpace::image, {{{0, 0, 0}, 10, 10}}};
    EXPECT_EQ(focus({10, 0}, {}), 0.0f);
    EXPECT_EQ(focus({10.001f, 0}, {}), 1.0f);
}

TEST(Focus, SeveralPointsCombine) {
    Focus focus{FocusSpace::image, {{{0, 0, 0}, 0, 10}, {{10, 0, 0}, 0, 10}}};
    EXPECT_FLOAT_EQ(focus({2, 0}, {}), 0.2f);
    EXPECT_FLOAT_EQ(focus({5, 0}, {}), 0.5f);
    focus.sum = true;
    EXPECT_FLOAT_EQ(focus({5, 0}, {}), 0.0f);
    EXPECT_FLOAT_EQ(focus({-5, 0}, {}), 0.5f);
}

/// A segment of four samples from one end of the image, near, to the other, far.
ClippedPaths segment(bool orthographic) {
    ClippedPaths clipped;
    clipped.px = {{0, 0}, {8, 0}};
    clipped.position_view = {{-1, 0, -1}, {3, 0, -3}};
    clipped.sample_start = {0, 4};
    clipped.sample_count = {4, 0};
    clipped.samples = 4;
    clipped.orthographic = orthographic;
    return clipped;
}

TEST(Focus, OfSamplesIsThatOfTheirPlaces) {
    for (const bool orthographic : {false, true}) {
        const ClippedPaths clipped = segment(orthographic);
        const Array<float> in_image = focus_of_samples(clipped, {FocusSpace::image, {{{1, 0, 0}, 0, 4}}});
        EXPECT_FLOAT_EQ(in_image[0], 0.0f);
        EXPECT_FLOAT_EQ(in_image[1], 0.5f);
        EXPECT_FLOAT_EQ(in_image[2], 1.0f);
        // In perspective a place on the image's way is that share of 1/distance.
        const Array<float> distance = distance_of_samples(clipped, 0, 10);
        for (int j = 0; j < 4; ++j) {
            const float s = (j + 0.5f) / 4, expected = orthographic ? 1 + 2 * s : 1 / ((1 - s) / 1 + s / 3);
            EXPECT_NEAR(distance[j], expected / 10, 1e-6f);
        }
    }
}

TEST(Focus, OfPixelsIsThatOfWhatTheyShow) {
    View view;
    view.width = 4;
    view.height = 2;
    view.orthographic = true;
    view.view_to_clip = dmat4(0.5, 0, 0, 0, 0, 1, 0, 0, 0, 0, -0.1, 0, 0, 0, -1, 1);  // 4 x 2 units
    const float distance[] = {5, 5, 5, infinity, 9, 5, 5, 5};
    const Focus focus{FocusSpace::scene, {{{-1.5f, -0.5f, -5}, 0, 4}}};
    const Array<float> f = focus_of_pixels(view, distance, focus);
    EXPECT_NEAR(f[0], 0.0f, 1e-6f);
    EXPECT_NEAR(f[1], 0.25f, 1e-6f);
    EXPECT_NEAR(f[2], 0.5f, 1e-6f);
    EXPECT_EQ(f[3], 1.0f);
    EXPECT_EQ(f[4], 1.0f);
    EXPECT_EQ(focus_of_pixels(view, distance, {})[3], 0.0f);
    EXPECT_THROW(focus_of_pixels(view, {distance, 3}, focus), std::invalid_argument);
}

}  // namespace
}  // namespace fovea
