// SPDX-License-Identifier: GPL-3.0-or-later
// Pictures as layers, and in black and white alone.
#include <algorithm>
#include <gtest/gtest.h>
#include <numeric>

#include <fovea/color/displayed.h>
#include <fovea/color/screentone.h>
#include <fovea/color/srgb.h>
#include <fovea/draw/layered.h>

#include "refused.h"
#include "vector_drawings.h"

using namespace fovea;
using namespace fovea::draw;
using namespace fovea::vector_drawings;

namespace {

style::Style two_sets() {
    style::Style style = tool::style_of({"contour"});
    style.line_sets[0].name = "outline";
    style.line_sets.push_back(tool::style_of({"crease"}).line_sets[0]);
    style.line_sets[1].name = "edges";
    style.line_sets[1].hidden.push_back({});
    return style;
}

std::vector<std::string> names_of(const LayeredPicture& picture) {
    std::vector<std::string> names;
    for (const PictureLayer& layer : picture.layers) names.push_back(layer.group + "/" + layer.name);
    return names;
}

double white_share(float gray, const Screen& screen = {}) {
    constexpr int size = 400;
    const Array<vec4> nothing(std::size_t(size) * size, vec4(0.0f)), ground(nothing.size(), vec4(vec3(gray), 1.0f));
    const Array<std::uint8_t> bits = screentone(nothing, ground, dvec3(1.0), size, screen);
    return std::accumulate(bits.begin(), bits.end(), 0.0) / double(bits.size());
}

}  // namespace

TEST(Layered, HasPaperAndTheLinesOfEachSetWithHiddenOnesApart) {
    Frame frame = cube(two_sets(), 90, 90);
    const LayeredPicture picture = layered(frame);
    EXPECT_EQ(names_of(picture),
              (std::vector<std::string>{"/paper", "1 outline/visible", "2 edges/hidden", "2 edges/visible"}));
    for (const PictureLayer& layer : picture.layers) EXPECT_EQ(layer.png.substr(1, 3), "PNG");
    EXPECT_EQ(picture.merged.substr(1, 3), "PNG");
    style::Style transparent = two_sets();
    transparent.paper.transparent = true;
    Frame seen_through = cube(transparent, 90, 90);
    EXPECT_EQ(names_of(layered(seen_through)).front(), "1 outline/visible");
}

TEST(Layered, LinesOfAllPensTogetherAreThoseOfThePicture) {
    Frame frame = cube(two_sets(), 90, 90);
    frame.ink();
    const Array<std::uint8_t> all(frame.pens.pens.size(), 1), none_of_them(frame.pens.pens.size(), 0);
    EXPECT_EQ(frame.lines_of(all), frame.passes.lines);
    for (const vec4& pixel : frame.lines_of(none_of_them)) EXPECT_EQ(pixel.a, 0.0f);
    EXPECT_EQ(frame.lines_of(all), frame.passes.lines);
}

TEST(Layered, ColorsBetweenTwoPicturesMakeOneOfTheOther) {
    const Array<vec4> below{vec4(1, 1, 1, 1), vec4(0.8f, 0.8f, 0.5f, 1), vec4(0.2f, 0.5f, 0.1f, 1)};
    const Array<vec4> above{vec4(0.1f, 0.4f, 1, 1), vec4(0.8f, 0.8f, 0.5f, 1), vec4(0.9f, 0.1f, 0.1f, 1)};
    const Array<std::uint8_t> bytes = color::bytes_between(below, above, {});
    EXPECT_EQ(bytes[7], 0);  // where nothing changes
    for (std::size_t i = 0; i < below.size(); ++i) {
        const dvec3 from = color::displayed(dvec3(vec3(below[i]))), to = color::displayed(dvec3(vec3(above[i])));
        const double alpha = bytes[4 * i + 3] / 255.0;
        for (int c = 0; c < 3; ++c)
            EXPECT_NEAR((1.0 - alpha) * from[c] + alpha * bytes[4 * i + c] / 255.0, to[c], 0.006) << i << " " << c;
    }
}

TEST(Screentone, DotsCoverTheShareThatAGrayLacksToWhite) {
    for (const float shown : {0.0f, 0.2f, 0.5f, 0.75f, 1.0f}) {
        const float linear = shown <= 0.0f ? 0.0f : std::pow((shown + 0.055f) / 1.055f, 2.4f);
        EXPECT_NEAR(white_share(linear), shown, 0.01) << shown;
        EXPECT_NEAR(white_share(linear, {.lines_per_inch = 20.0, .angle = 15.0}), shown, 0.02) << shown;
    }
}

TEST(Screentone, LinesAreBlackOrWhiteFromTheThresholdOn) {
    const Array<vec4> lines{vec4(0, 0, 0, 0.6f), vec4(0, 0, 0, 0.4f), vec4(0.9f, 0.9f, 0.9f, 0.9f)};
    const Array<vec4> ground{vec4(1), vec4(1), vec4(0, 0, 0, 1)};
    EXPECT_EQ(screentone(lines, ground, dvec3(1.0), 3, {}), (Array<std::uint8_t>{0, 1, 1}));
}

TEST(Screentone, AScreenThatCannotBeIsRefused) {
    const Array<vec4> one(1, vec4(1));
    EXPECT_NE(refused([&] { screentone(one, one, dvec3(1.0), 1, {.dpi = 100.0}); }).find("dots are smaller"),
              std::string::npos);
    EXPECT_EQ(refused([&] { screentone(one, one, dvec3(1.0), 1, {.dpi = 1.0}); }),
              "screen: dpi is 1, outside 50 to 2400");
    EXPECT_EQ(page_height({}, 210.0), 4961);
}
