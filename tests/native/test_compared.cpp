// SPDX-License-Identifier: GPL-3.0-or-later
// Drawings compared: distances against brute force, measures against closed forms.
#include <cmath>
#include <gtest/gtest.h>
#include <numbers>
#include <random>

#include <fovea/study/measures.h>
#include <fovea/study/nearest_pixel.h>
#include <fovea/study/parts.h>
#include <fovea/study/scan.h>
#include <fovea/study/thin.h>

namespace fovea {
namespace {

using namespace study;

using Line = std::array<vec2, 2>;

Bitmap drawn(const std::vector<Line>& lines, int width = 256, int height = 192) {
    std::vector<vec2> px;
    std::vector<std::int64_t> offsets{0};
    for (const Line& line : lines) {
        px.insert(px.end(), line.begin(), line.end());
        offsets.push_back(std::int64_t(px.size()));
    }
    return pixels_of(px, offsets, width, height);
}

Bitmap random_pixels(int width, int height, double share, unsigned seed) {
    std::mt19937 random(seed);
    std::bernoulli_distribution set(share);
    Bitmap bitmap(width, height);
    for (auto& value : bitmap.set) value = set(random);
    return bitmap;
}

TEST(Compared, DistancesAreThoseToTheNearestOfAllPixels) {
    for (unsigned seed = 0; seed < 20; ++seed) {
        const int width = 1 + int(seed * 7 % 41), height = 1 + int(seed * 5 % 23);
        const Bitmap bitmap = random_pixels(width, height, seed % 2 ? 0.02 : 0.3, seed);
        const Array<float> found = distances_to(bitmap);
        for (std::size_t i = 0; i < found.size(); ++i) {
            double least = INFINITY;
            for (std::size_t k = 0; k < found.size(); ++k)
                if (bitmap.set[k]) least = std::min(least, glm::distance(center_of(i, width), center_of(k, width)));
            ASSERT_EQ(found[i], float(least)) << seed << ", pixel " << i;
        }
    }
}

TEST(Compared, ADrawingIsAllThatItJudgesItselfToBe) {
    const Bitmap bitmap = drawn({{vec2(10, 10), vec2(200, 120)}, {vec2(30, 150), vec2(220, 30)}});
    const Measures found = compare(bitmap, bitmap, 0.0);
    EXPECT_EQ(found.precision, 1.0);
    EXPECT_EQ(found.recall, 1.0);
    EXPECT_EQ(found.f1, 1.0);
    EXPECT_EQ(found.chamfer_px, 0.0);
    EXPECT_EQ(found.iou, 1.0);
}

TEST(Compared, AShiftedLineIsNearUpToTheShift) {
    const Bitmap line = drawn({{vec2(0.5, 50.5), vec2(255.5, 50.5)}}),
                 other = drawn({{vec2(0.5, 57.5), vec2(255.5, 57.5)}});
    EXPECT_EQ(compare(line, other, 7.0).precision, 1.0);
    EXPECT_EQ(compare(line, other, 7.0).recall, 1.0);
    EXPECT_EQ(compare(line, other, 6.9).f1, 0.0);
    EXPECT_EQ(compare(line, other, 0.0).chamfer_px, 7.0);
    // Bands 15 rows high, 7 rows apart: 8 in common of 22.
    EXPECT_NEAR(compare(line, other, 7.0).iou, 8.0 / 22.0, 1e-12);
}

TEST(Compared, HalfOfALineIsPreciseAndRecallsHalfOfIt) {
    const Bitmap half = drawn({{vec2(0.5, 50.5), vec2(127.5, 50.5)}}),
                 line = drawn({{vec2(0.5, 50.5), vec2(255.5, 50.5)}});
    const Measures found = compare(half, line, 3.0);
    EXPECT_EQ(found.precision, 1.0);
    EXPECT_NEAR(found.recall, (128.0 + 3.0) / 256.0, 1e-12);
}

TEST(Compared, AnEmptyDrawingIsPreciseAndRecallsNothing) {
    const Bitmap empty(256, 192), line = drawn({{vec2(0.5, 50.5), vec2(255.5, 50.5)}});
    EXPECT_EQ(compare(empty, line, 3.0).precision, 1.0);
    EXPECT_EQ(compare(empty, line, 3.0).recall, 0.0);
    EXPECT_EQ(compare(empty, line, 3.0).f1, 0.0);
    EXPECT_EQ(compare(line, empty, 3.0).precision, 0.0);
    EXPECT_EQ(compare(empty, empty, 3.0).f1, 1.0);
    EXPECT_THROW(compare(empty, Bitmap(255, 192), 3.0), std::invalid_argument);
}

TEST(Compared, RandomLinesRecallWhatTheirDensityAndTheToleranceSay) {
    constexpr int side = 384, draws = 24, count = 27;
    const double reach = side * std::numbers::sqrt2, density = count / reach;  // length per area
    Bitmap all(side, side);
    std::ranges::fill(all.set, std::uint8_t(1));
    for (const double tolerance : {10.0, 20.0}) {
        double recall = 0.0;
        for (unsigned seed = 0; seed < draws; ++seed) {
            std::mt19937 random(seed);
            std::uniform_real_distribution<double> angle(0.0, std::numbers::pi), offset(-0.5 * reach, 0.5 * reach);
            std::vector<Line> lines;
            for (int i = 0; i < count; ++i) {
                const double turn = angle(random), away = offset(random);
                const dvec2 along(std::cos(turn), std::sin(turn)),
                    foot = dvec2(0.5 * side) + away * dvec2(-along.y, along.x);
                lines.push_back({vec2(foot - reach * along), vec2(foot + reach * along)});
            }
            recall += compare(drawn(lines, side, side), all, tolerance).recall / draws;
        }
        EXPECT_NEAR(recall, 1.0 - std::exp(-2.0 * tolerance * density), 0.04) << tolerance;
    }
}

TEST(Compared, AThickStrokeIsThinnedToTheLineInItsMiddle) {
    Bitmap stroke(100, 60);
    for (int y = 20; y < 29; ++y)
        for (int x = 10; x < 90; ++x) stroke.set[std::size_t(y * 100 + x)] = 1;
    const Bitmap line = thinned(stroke);
    std::vector<int> in_column(100);
    for (std::size_t i = 0; i < line.set.size(); ++i)
        if (line.set[i]) {
            ++in_column[i % 100];
            EXPECT_NEAR(double(i / 100), 24.0, 1.0);
        }
    for (int x = 20; x < 80; ++x) EXPECT_EQ(in_column[std::size_t(x)], 1);
}

TEST(Compared, ThinningKeepsWhatIsConnectedAndWhatIsLine) {
    const Bitmap wires =
        drawn({{vec2(5, 5), vec2(60, 45)}, {vec2(5, 45), vec2(60, 5)}, {vec2(70, 5), vec2(70, 40)}}, 80, 50);
    for (const Bitmap& bitmap : {wires, random_pixels(40, 30, 0.5, 1), random_pixels(40, 30, 0.8, 2)}) {
        const Bitmap thin = thinned(bitmap);
        EXPECT_EQ(parts_of(thin).count(), parts_of(bitmap).count());
        EXPECT_EQ(thinned(thin).set, thin.set);
        for (std::size_t i = 0; i < thin.set.size(); ++i) EXPECT_LE(thin.set[i], bitmap.set[i]);
    }
    EXPECT_GE(compare(thinned(wires), wires, 1.0).recall, 0.99);
}

TEST(Compared, InkIsWhatIsDarkerThanUnevenPaperAndNoSpeck) {
    constexpr int width = 320, height = 240;
    color::GrayImage scan{width, height, Array<std::uint8_t>(std::size_t(width * height))};
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            const bool is_line = y >= 100 && y < 104 && x >= 20 && x < 300, is_speck = x == 50 && y == 50;
            scan.values[std::size_t(y * width + x)] = std::uint8_t((is_line || is_speck ? 0.6 : 1.0) * (150 + x / 4));
        }
    const Bitmap lines = thinned(ink_of(scan));
    const Bitmap truth = drawn({{vec2(20, 101.5), vec2(300, 101.5)}}, width, height);
    EXPECT_EQ(compare(lines, truth, 2.0).f1, 1.0);
    for (auto& value : scan.values) value = std::uint8_t(255 - value);
    EXPECT_EQ(compare(thinned(ink_of(scan)), truth, 2.0).f1, 1.0) << "bright lines on dark paper";
}

}  // namespace
}  // namespace fovea
