// SPDX-License-Identifier: GPL-3.0-or-later
// Widths and darkness of strokes, measured in drawings of known ones.
#include <cmath>
#include <gtest/gtest.h>
#include <random>

#include <fovea/color/srgb.h>
#include <fovea/study/scan.h>
#include <fovea/study/stroke_look.h>
#include <fovea/study/thin.h>

namespace fovea {
namespace {

using namespace study;

constexpr int width = 480, height = 360;

/// Distance of a point from the nearest of some lines: rings, and spokes of all directions.
double distance_from_lines(const dvec2& p) {
    double least = INFINITY;
    for (const double radius : {55.0, 110.0, 150.0})
        least = std::min(least, std::abs(glm::distance(p, {160.3, 180.7}) - radius));
    for (int i = 0; i < 5; ++i) {
        const double angle = 0.1 + 0.6 * i;
        const dvec2 along(std::cos(angle), std::sin(angle)), from(400.2, 40.4 + 70.0 * i);
        const double t = std::clamp(glm::dot(p - from, along), -28.0, 28.0);
        least = std::min(least, glm::distance(p, from + t * along));
    }
    return least;
}

struct Look {
    double width, darkness;  ///< in pixels, and of the paper's light
    double paper = 1.0;      ///< light
    bool of_values = false;  ///< borders mix values, as programs that paint do, not light
    double noise = 0.0;      ///< standard deviation of values, of 255
};

color::GrayImage drawing_of(const Look& look) {
    constexpr int samples = 8;
    std::mt19937 random(3);
    std::normal_distribution<double> noise(0.0, std::max(look.noise, 1e-9));
    color::GrayImage picture{width, height, Array<std::uint8_t>(std::size_t(width) * height)};
    const auto value = [](double light) { return double(color::to_srgb(float(light))); };
    const double ink = look.paper * (1.0 - look.darkness);
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            const double near = distance_from_lines({x + 0.5, y + 0.5}) - 0.5 * look.width;
            const bool is_between = std::abs(near) < 1.0;
            double share = near <= -1.0 ? 1.0 : 0.0;
            if (is_between)
                for (int i = 0; i < samples * samples; ++i) {
                    const dvec2 at(x + (i % samples + 0.5) / samples, y + (i / samples + 0.5) / samples);
                    share += (distance_from_lines(at) < 0.5 * look.width) / double(samples * samples);
                }
            const double as_seen = look.of_values ? std::lerp(value(look.paper), value(ink), share)
                                                  : value(std::lerp(look.paper, ink, share));
            picture.values[std::size_t(y) * width + std::size_t(x)] =
                std::uint8_t(std::clamp(std::lround(255.0 * as_seen + noise(random)), 0l, 255l));
        }
    return picture;
}

double median(Array<float> values) {
    std::nth_element(values.begin(), values.begin() + std::ptrdiff_t(values.size() / 2), values.end());
    return double(values[values.size() / 2]);
}

StrokeLooks measured(const color::GrayImage& picture) { return looks_of(picture, thinned(ink_of(picture))); }

TEST(StrokeLook, WidthsAreFoundAgainFromOneAndAHalfPixelsOn) {
    for (const bool of_values : {false, true})
        for (const double darkness : {1.0, 0.7, 0.4})
            for (const double wide : {1.5, 1.8, 2.0, 2.6, 3.0, 4.5, 7.0, 12.0}) {
                const StrokeLooks found =
                    measured(drawing_of({.width = wide, .darkness = darkness, .of_values = of_values}));
                ASSERT_GT(found.pixel.size(), 500u);
                EXPECT_NEAR(median(found.width) / wide, 1.0, 0.03) << wide << " " << darkness << " " << of_values;
                EXPECT_NEAR(median(found.darkness) / darkness, 1.0, 0.02)
                    << wide << " " << darkness << " " << of_values;
            }
}

TEST(StrokeLook, OnGrayPaperWithTheNoiseOfAScannerToo) {
    for (const double wide : {1.5, 2.5, 6.0}) {
        const StrokeLooks found = measured(drawing_of({.width = wide, .darkness = 0.8, .paper = 0.75, .noise = 2.0}));
        EXPECT_NEAR(median(found.width) / wide, 1.0, 0.05) << wide;
        EXPECT_NEAR(median(found.darkness), 0.8, 0.03) << wide;
    }
}

TEST(StrokeLook, LinesThatLieAlikeOnThePixelsAreAsWideAsTheyWerePainted) {
    color::GrayImage picture{200, 200, Array<std::uint8_t>(40000, 255)};
    for (std::size_t y = 20; y < 180; y += 20)
        for (std::size_t x = 20; x < 180; ++x) {
            picture.values[y * 200 + x] = 0;
            picture.values[(y - 1) * 200 + x] = picture.values[(y + 1) * 200 + x] = 191;  // a quarter of their ink
        }
    EXPECT_NEAR(median(measured(picture).width), 1.5, 0.02);
}

TEST(StrokeLook, BrightLinesOnDarkPaperHaveAWidthAndNoDarkness) {
    color::GrayImage picture = drawing_of({.width = 3.0, .darkness = 1.0, .of_values = true});
    for (std::uint8_t& value : picture.values) value = std::uint8_t(255 - value);
    const StrokeLooks found = measured(picture);
    EXPECT_NEAR(median(found.width), 3.0, 0.3);
    EXPECT_TRUE(std::ranges::all_of(found.darkness, [](float value) { return std::isnan(value); }));
}

TEST(StrokeLook, EmptyPaperHasNoStrokes) {
    const color::GrayImage paper{40, 30, Array<std::uint8_t>(1200, 230)};
    EXPECT_TRUE(measured(paper).pixel.empty());
    EXPECT_THROW(looks_of(paper, Bitmap(41, 30)), std::invalid_argument);
}

}  // namespace
}  // namespace fovea
