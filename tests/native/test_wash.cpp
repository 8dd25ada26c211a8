// SPDX-License-Identifier: GPL-3.0-or-later
// What water does to washes: pictures are one row, read from left to right, on white paper.
#include <cmath>
#include <gtest/gtest.h>
#include <numeric>

#include <fovea/color/wash.h>

namespace fovea::color {
namespace {

/// A row of so many pixels of a picture in which a millimeter is `px_per_mm` wide, with its axis at the left.
View row(int width, double px_per_mm) {
    View view;
    view.width = width;
    view.height = 1;
    view.orthographic = true;
    view.reference_scale = px_per_mm * style::Paper().height_mm / reference_height;
    view.view_to_clip = dmat4(1.0);
    view.view_to_clip[3] = dvec4(-1.0, -1.0, 0.0, 1.0);
    return view;
}

vec4 gray(float value) { return {value, value, value, 1.0f}; }

TEST(Wash, ADensityPerPixelOnlyIfTheStyleAsksForIt) {
    const Array<vec4> layer(8, gray(0.5f));
    style::Color color;
    EXPECT_TRUE(wash_density(layer, row(8, 4.0), nullptr, {}, color).empty());
    color.backruns = 1.0;  // without a map of the water there are none
    EXPECT_TRUE(wash_density(layer, row(8, 4.0), nullptr, {}, color).empty());
    color.edge_darkening = 0.5;
    EXPECT_TRUE(wash_density({}, row(8, 4.0), nullptr, {}, color).empty());
    for (float factor : wash_density(layer, row(8, 4.0), nullptr, {}, color))
        EXPECT_NEAR(factor, 1.0f, 1e-5f) << "there is no edge";
    EXPECT_THROW((void)wash_density(layer, row(9, 4.0), nullptr, {}, color), std::invalid_argument);
}

TEST(Wash, EdgesDarkenInsideTheDenserWash) {
    // Bare paper, a light wash, a dark one; 40 pixels, 10 mm, each.
    Array<vec4> layer(40, vec4(0.0f));
    layer.insert(layer.end(), 40, gray(0.6f));
    layer.insert(layer.end(), 40, gray(0.2f));
    style::Color color;
    color.edge_darkening = 0.5;
    const Array<float> factor = wash_density(layer, row(120, 4.0), nullptr, {}, color);
    for (int i : {0, 20, 39, 60, 79, 100, 119}) EXPECT_NEAR(factor[i], 1.0f, 0.02f) << i;
    EXPECT_GT(factor[40], 1.3f) << "beside paper";
    EXPECT_LE(factor[40], 1.5f);
    EXPECT_GT(factor[80], 1.15f) << "beside a lighter wash";
    EXPECT_LT(factor[80], factor[40]);
    for (int i = 40; i < 50; ++i) EXPECT_GE(factor[i], factor[i + 1] - 1e-6f) << "less and less inwards: " << i;
}

TEST(Wash, EdgesAreAsWideOnPaperAtEveryResolution) {
    style::Color color;
    color.edge_darkening = 1.0;
    const auto width_mm = [&](int px_per_mm) {
        Array<vec4> layer(std::size_t(10) * px_per_mm, vec4(0.0f));
        layer.insert(layer.end(), std::size_t(10) * px_per_mm, gray(0.3f));
        const Array<float> factor = wash_density(layer, row(20 * px_per_mm, px_per_mm), nullptr, {}, color);
        return (std::accumulate(factor.begin(), factor.end(), 0.0) - double(factor.size())) / px_per_mm;
    };
    EXPECT_NEAR(width_mm(8), width_mm(32), 0.1 * width_mm(32));
    EXPECT_GT(width_mm(32), 0.05);
}

TEST(Wash, BackrunsMovePigmentFromWhereTheWaterIsHighAndKeepTheMean) {
    const PaperTexture water(Array<float>{0.0f, 1.0f, 2.0f, 3.0f}, 4, 1, 4.0);
    style::Color color;
    color.backruns = 0.5;
    const Array<float> factor = wash_density(Array<vec4>(4, gray(0.5f)), row(4, 1.0), &water, {}, color);
    EXPECT_EQ(factor, (Array<float>{1.375f, 1.125f, 0.875f, 0.625f}));
}

}  // namespace
}  // namespace fovea::color
