// SPDX-License-Identifier: GPL-3.0-or-later
// Salience: what stands out of pictures of discs and bars, and where eyes go by it.
#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <numbers>

#include <fovea/base/threads.h>
#include <fovea/study/fixations.h>
#include <fovea/study/salience.h>

namespace fovea {
namespace {

using namespace study;
using color::RgbImage;
using Rgb = std::array<std::uint8_t, 3>;

constexpr int full_width = 640, full_height = 480;
constexpr double shape = double(full_width) / full_height;
constexpr Rgb white{255, 255, 255}, gray{120, 120, 120}, red{200, 40, 40}, green{40, 160, 40};

RgbImage paper(Rgb color = white) {
    RgbImage picture{full_width, full_height, {}};
    for (int i = 0; i < full_width * full_height; ++i)
        picture.values.insert(picture.values.end(), color.begin(), color.end());
    return picture;
}

template <typename Inside>
void fill(RgbImage& picture, Rgb color, const Inside& inside) {
    for (int y = 0; y < picture.height; ++y)
        for (int x = 0; x < picture.width; ++x)
            if (inside(dvec2(x + 0.5, y + 0.5)))
                std::ranges::copy(color, picture.values.begin() + 3 * (std::ptrdiff_t(y) * picture.width + x));
}

void add_disc(RgbImage& picture, Rgb color, const dvec2& middle, double radius) {
    fill(picture, color, [&](const dvec2& at) { return glm::distance(at, middle) < radius; });
}

void add_bar(RgbImage& picture, Rgb color, const dvec2& middle, double angle) {
    const dvec2 along(std::cos(angle), std::sin(angle)), across(-along.y, along.x);
    fill(picture, color, [&](const dvec2& at) {
        return std::abs(glm::dot(at - middle, along)) < 24.0 && std::abs(glm::dot(at - middle, across)) < 4.0;
    });
}

/// Middles of 4 x 3 tiles of the picture.
dvec2 tile(int i) { return {(i % 4 + 0.5) * full_width / 4.0, (i / 4 + 0.5) * full_height / 3.0}; }

/// Discs of one color on paper, but for one.
RgbImage discs(Rgb color, int odd, Rgb of_odd) {
    RgbImage picture = paper();
    for (int i = 0; i < 12; ++i) add_disc(picture, i == odd ? of_odd : color, tile(i), 28.0);
    return picture;
}

dvec2 first_px(const Plane& salience) {
    const auto found = fixations(salience, shape, 1);
    return found.empty() ? dvec2(NAN) : found.front().at * dvec2(full_width, full_height);
}

TEST(Salience, TheEyeGoesToTheDiscOfAnotherColorFirst) {
    for (const int odd : {0, 5, 11})
        for (const RgbImage& picture : {discs(green, odd, red), discs(red, odd, green), discs(gray, odd, red)})
            EXPECT_LT(glm::distance(first_px(itti_koch(picture)), tile(odd)), 40.0) << odd;
}

TEST(Salience, TheEyeGoesToTheBarThatIsTurnedFirst) {
    for (const int odd : {1, 6}) {
        RgbImage picture = paper();
        for (int i = 0; i < 12; ++i) add_bar(picture, gray, tile(i), i == odd ? std::numbers::pi / 2.0 : 0.0);
        EXPECT_LT(glm::distance(first_px(itti_koch(picture)), tile(odd)), 40.0) << odd;
    }
}

TEST(Salience, TheEyeGoesToTheOneDiscOnPaper) {
    for (const int only : {0, 6, 11})
        for (const Rgb& color : {gray, red}) {
            RgbImage picture = paper();
            add_disc(picture, color, tile(only), 28.0);
            for (const auto& model : {itti_koch, spectral_residual})
                EXPECT_LT(glm::distance(first_px(model(picture)), tile(only)), 40.0) << only;
        }
}

TEST(Salience, NothingStandsOutOfOneColor) {
    for (const Rgb& color : {white, gray, red}) {
        const Plane salience = itti_koch(paper(color));
        EXPECT_EQ(*std::ranges::max_element(salience.values), 0.0f);
        EXPECT_TRUE(fixations(salience, shape, 5).empty());
        EXPECT_TRUE(fixations(spectral_residual(paper(color)), shape, 5).empty());
        Plane left(2, 1);
        left.values[0] = 1.0f;
        EXPECT_NEAR(salient_share(salience, left), 0.5, 1e-6);
    }
}

TEST(Salience, AMirroredPictureHasMirroredSalience) {
    RgbImage picture = discs(green, 6, red), mirrored = picture;
    add_bar(picture, gray, dvec2(200.0, 100.0), 0.7);
    for (int y = 0; y < full_height; ++y)
        for (int x = 0; x < full_width; ++x)
            std::copy_n(picture.values.begin() + 3 * (y * full_width + x), 3,
                        mirrored.values.begin() + 3 * (y * full_width + full_width - 1 - x));
    for (const auto& model : {itti_koch, spectral_residual}) {
        const Plane one = model(picture), other = model(mirrored);
        const float most = *std::ranges::max_element(one.values);
        for (int y = 0; y < one.height; ++y)
            for (int x = 0; x < one.width; ++x)
                ASSERT_NEAR(one.at(x, y), other.at(one.width - 1 - x, y), 5e-3f * most) << x << " " << y;
    }
}

TEST(Salience, ItIsThatOfTheSamePictureInMorePixels) {
    const RgbImage picture = discs(green, 6, red);
    RgbImage larger{2 * full_width, 2 * full_height, {}};
    larger.values.resize(4 * picture.values.size());
    for (int y = 0; y < larger.height; ++y)
        for (int x = 0; x < larger.width; ++x)
            std::copy_n(picture.values.begin() + 3 * (y / 2 * full_width + x / 2), 3,
                        larger.values.begin() + 3 * (y * larger.width + x));
    const Plane one = itti_koch(picture), other = itti_koch(larger);
    ASSERT_EQ(one.width, other.width);
    ASSERT_EQ(one.height, other.height);
    const float most = *std::ranges::max_element(one.values);
    for (std::size_t i = 0; i < one.values.size(); ++i) ASSERT_NEAR(one.values[i], other.values[i], 0.05f * most);
}

TEST(Salience, ItDoesNotChangeWhereAPictureIsDarker) {
    RgbImage bright = discs({80, 160, 80}, 6, {160, 80, 80}), dark = bright;
    for (std::uint8_t& value : dark.values) value = std::uint8_t(value / 2);
    for (std::size_t i = 0; i < bright.values.size(); ++i) bright.values[i] = std::uint8_t(2 * dark.values[i]);
    const Plane one = itti_koch(bright), other = itti_koch(dark);
    const float most = *std::ranges::max_element(one.values);
    for (std::size_t i = 0; i < one.values.size(); ++i) ASSERT_NEAR(one.values[i], other.values[i], 1e-3f * most);
}

TEST(Salience, ItIsTheSameForAnyNumberOfThreads) {
    const RgbImage picture = discs(green, 6, red);
    const Plane one = itti_koch(picture), residual = spectral_residual(picture);
    limit_threads(1);
    const Plane alone = itti_koch(picture), residual_alone = spectral_residual(picture);
    limit_threads(0);
    EXPECT_EQ(alone.values, one.values);
    EXPECT_EQ(residual_alone.values, residual.values);
}

TEST(Salience, EyesGoFromTheMostSalientPlaceToThoseAwayFromIt) {
    Plane salience(40, 30);
    salience.at(10, 10) = 1.0f;
    salience.at(12, 10) = 0.9f;  // 32 pixels away, within a sixth of the height
    salience.at(30, 20) = 0.5f;
    const auto found = fixations(salience, shape, 5);
    ASSERT_EQ(found.size(), 2u);
    EXPECT_EQ(found[0].at, dvec2(10.5 / 40.0, 10.5 / 30.0));
    EXPECT_EQ(found[0].salience, 1.0);
    EXPECT_EQ(found[1].at, dvec2(30.5 / 40.0, 20.5 / 30.0));
    EXPECT_EQ(found[1].salience, 0.5);
}

TEST(Salience, TheShareOfAPlaceIsThatOfTheSalienceInIt) {
    Plane salience(40, 30), right(80, 60);
    salience.at(5, 5) = 3.0f;
    salience.at(35, 5) = 1.0f;
    for (int y = 0; y < right.height; ++y)
        for (int x = 40; x < right.width; ++x) right.at(x, y) = 1.0f;
    EXPECT_NEAR(salient_share(salience, right), 0.25, 1e-6);
}

TEST(Salience, AResizedPictureKeepsItsMeanAndWhatIsLinear) {
    Plane ramp(64, 48);
    for (int y = 0; y < ramp.height; ++y)
        for (int x = 0; x < ramp.width; ++x) ramp.at(x, y) = float((x + 0.5) / ramp.width);
    const Plane half = resized(ramp, 32, 24), back = resized(half, 64, 48);
    for (int x = 1; x + 1 < half.width; ++x) EXPECT_NEAR(half.at(x, 5), (x + 0.5) / half.width, 1e-6);
    for (int x = 4; x + 4 < back.width; ++x) EXPECT_NEAR(back.at(x, 9), ramp.at(x, 9), 1e-6);
}

}  // namespace
}  // namespace fovea
