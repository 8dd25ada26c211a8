// SPDX-License-Identifier: GPL-3.0-or-later
// Lines along the crests of probabilities.
#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>

#include <fovea/study/measures.h>
#include <fovea/study/probable_lines.h>

namespace fovea {
namespace {

using namespace study;

constexpr int width = 400, height = 300;
constexpr double sigma = 1.6;

template <typename Value>
Plane plane(const Value& value) {
    Plane made(width, height);
    for (std::size_t i = 0; i < made.values.size(); ++i) made.values[i] = float(value(center_of(i, width)));
    return made;
}

double bump(double distance) { return std::exp(-0.5 * distance * distance / (sigma * sigma)); }

template <typename Distance>
Bitmap pixels_within(double least, const Distance& distance) {
    Bitmap made(width, height);
    for (std::size_t i = 0; i < made.set.size(); ++i) made.set[i] = std::abs(distance(center_of(i, width))) < least;
    return made;
}

const auto to_circle = [](const dvec2& at) { return glm::distance(at, dvec2(201.3, 148.7)) - 90.0; };

}  // namespace

TEST(ProbableLines, LieOnTheMiddleOfALikelyBandOnePixelWide) {
    const Bitmap lines = lines_of(crests_of(plane([](const dvec2& at) { return 0.7 * bump(to_circle(at)); })), 0.3);
    const auto far = pixels_within(1.0, to_circle);
    for (std::size_t i = 0; i < lines.set.size(); ++i)
        if (lines.set[i]) {
            EXPECT_LT(std::abs(to_circle(center_of(i, width))), 1.0);
        }
    EXPECT_EQ(compare(far, lines, 2.0).precision, 1.0) << "there are no gaps";
    EXPECT_LT(double(lines.count()), 2.0 * 3.1416 * 90.0);
}

TEST(ProbableLines, GoOnDownToHalfOfTheThresholdAndNotFurther) {
    // A straight line that fades from 1 at the left to 0 at the right.
    const auto fading = [](const dvec2& at) { return (1.0 - at.x / width) * bump(at.y - 150.2); };
    const Strengths crests = crests_of(plane(fading));
    const float most = *std::max_element(crests.values.begin(), crests.values.end());
    const Bitmap lines = lines_of(crests, 0.5);
    int last = 0, weak = 0;
    for (std::size_t i = 0; i < lines.set.size(); ++i) {
        if (lines.set[i]) last = std::max(last, int(i % width));
        if (crests.values[i] >= 0.25f) weak = std::max(weak, int(i % width));
    }
    EXPECT_EQ(last, weak);
    EXPECT_NEAR(last, width * (1.0 - 0.25 / most), 6.0);
    EXPECT_EQ(lines_of(crests, 0.999).count(), 0u);
}

TEST(ProbableLines, AreNotWhereAllIsAsLikelyOrRisesEvenly) {
    EXPECT_EQ(lines_of(crests_of(plane([](const dvec2&) { return 0.8; })), 0.1).count(), 0u);
    EXPECT_EQ(lines_of(crests_of(plane([](const dvec2& at) { return at.x / width; })), 0.1).count(), 0u);
    EXPECT_EQ(lines_of(crests_of(Plane(3, 3)), 0.1).count(), 0u);
}

TEST(ProbableLines, AreNoSpecks) {
    const auto speck = [](const dvec2& at) { return bump(glm::distance(at, dvec2(100.0, 100.0))); };
    EXPECT_EQ(lines_of(crests_of(plane(speck)), 0.2).count(), 0u);
}

}  // namespace fovea
