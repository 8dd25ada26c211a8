// SPDX-License-Identifier: GPL-3.0-or-later
// Areas of colors: borders of known shapes, and what a cube's faces become.
#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <map>
#include <numbers>

#include <fovea/vector/areas.h>

#include "vector_drawings.h"

using namespace fovea;
using namespace fovea::draw;
using namespace fovea::vector;

namespace {

constexpr double tolerance = 0.02;
const Page page{dvec2(40.0), dvec2(0.0), 1.0, 1.0};

using Areas = std::map<Label, std::vector<Curve>>;

Areas areas_of(int width, int height, const LabelAt& label_at) {
    const auto found = outlines_of(borders_of(labels_of(width, height, 2, label_at), label_at), page, tolerance);
    return Areas(found.begin(), found.end());
}

/// Area within a curve: negative if it runs around clockwise.
double signed_area(const Curve& curve) {
    const Points flat = flattened(curve, 1e-4);
    double twice = 0.0;
    for (std::size_t i = 1; i < flat.size(); ++i) twice += cross(flat[i - 1], flat[i]);
    return 0.5 * twice;
}

double area(const std::vector<Curve>& curves) {
    double sum = 0.0;
    for (const Curve& curve : curves) sum += signed_area(curve);
    return sum;
}

bool in_square(const dvec2& p, double half) { return std::max(std::abs(p.x - 20.0), std::abs(p.y - 20.0)) < half; }

}  // namespace

TEST(Areas, OfADiscAreOneOfAFewCubicsAsLargeAsIt) {
    const Areas disc =
        areas_of(40, 40, [](const dvec2& p) { return glm::distance(p, dvec2(20.3, 19.9)) < 15.0 ? 1 : nothing; });
    ASSERT_EQ(disc.size(), 1u);
    const std::vector<Curve>& curves = disc.at(1);
    ASSERT_EQ(curves.size(), 1u);
    EXPECT_NEAR(area(curves), std::numbers::pi * 15.0 * 15.0, 2.0 * std::numbers::pi * 15.0 * tolerance);
    for (const dvec2& p : flattened(curves[0], 1e-4))
        EXPECT_NEAR(glm::distance(p, dvec2(20.3, 19.9)), 15.0, 1.5 * tolerance);
    EXPECT_LE(curves[0].cubic.size(), 5u);
}

TEST(Areas, OfASquareWithAHoleAreItsSidesTheHoleTheOtherWayAround) {
    const Areas ring =
        areas_of(40, 40, [](const dvec2& p) { return in_square(p, 15.2) && !in_square(p, 5.3) ? 7 : nothing; });
    ASSERT_EQ(ring.at(7).size(), 2u);
    EXPECT_GT(std::max(signed_area(ring.at(7)[0]), signed_area(ring.at(7)[1])), 0.0);
    EXPECT_LT(std::min(signed_area(ring.at(7)[0]), signed_area(ring.at(7)[1])), 0.0);
    // Corners are cut by half a pixel at most.
    EXPECT_NEAR(area(ring.at(7)), 30.4 * 30.4 - 10.6 * 10.6, 8 * 0.125 + (4 * 30.4 + 4 * 10.6) * tolerance);
    for (const Curve& curve : ring.at(7)) EXPECT_LE(curve.points.size(), 9u);
}

TEST(Areas, OfNeighborsHaveTheSameBorderAndFillTheFrame) {
    // A disc over two halves: three labels meet where it crosses the line between them.
    const auto label_at = [](const dvec2& p) -> Label {
        return glm::distance(p, dvec2(20.0)) < 8.0 ? 3 : p.x < 20.1 ? 1 : 2;
    };
    const Areas areas = areas_of(40, 40, label_at);
    ASSERT_EQ(areas.size(), 3u);
    double sum = 0.0;
    for (const auto& [label, curves] : areas) {
        for (const Curve& curve : curves) EXPECT_TRUE(curve.start() == curve.end() && curve.closed);
        EXPECT_GT(area(curves), 0.0);
        sum += area(curves);
    }
    EXPECT_NEAR(sum, 1600.0, 1e-3);
    EXPECT_NEAR(area(areas.at(3)), std::numbers::pi * 64.0, 1.1);
}

TEST(Areas, OfFewPointsBecomeThoseOfNeighbors) {
    const auto label_at = [](const dvec2& p) -> Label {
        for (const dvec2& speck : {dvec2(0.0), dvec2(7.5, 0.0), dvec2(3.0, 2.5)})
            if (glm::distance(p, speck) < 0.6) return 2;
        return p.y > 4.2 ? 3 : 1;
    };
    const auto left = [&](Index least) {
        const Labels labels = without_specks(labels_of(8, 6, 2, label_at), least);
        return std::ranges::count(labels.values, Label(2));
    };
    EXPECT_EQ(left(1), 3 + 4 + 5);
    EXPECT_EQ(left(4), 4 + 5);
    EXPECT_EQ(left(5), 5);
    EXPECT_EQ(left(6), 0);
}

TEST(Areas, OfAPictureOfNothingAreNone) {
    EXPECT_TRUE(areas_of(8, 6, [](const dvec2&) { return nothing; }).empty());
    const Areas all = areas_of(8, 6, [](const dvec2&) { return Label(0); });
    ASSERT_EQ(all.at(0).size(), 1u);
    EXPECT_EQ(all.at(0)[0].points.size(), 5u);
    EXPECT_NEAR(area(all.at(0)), 48.0, 1e-9);
}

TEST(Areas, OfACubeAreOneForEachBandOfItsFacesBelowTheLines) {
    style::Style style = tool::style_of({"contour", "crease"});
    style.color.shading = style::Shading::toon;
    const auto drawing_of = [&](Colors colors, bool lit) {
        Frame without = vector_drawings::cube(style, 160, 160);
        Job job = without.job;
        job.colors.emplace();
        job.colors->surfaces.resize(job.scene->placements.size());
        if (lit) job.colors->lights = {{.direction = {-0.9, 0.2, -0.4}, .color = vec3(3.0f)}};
        Frame frame(std::move(job));
        return compose(frame, {.colors = colors});
    };
    const Drawing picture = drawing_of(Colors::picture, true), areas = drawing_of(Colors::areas, true);
    EXPECT_TRUE(picture.document.image);
    EXPECT_FALSE(areas.document.image);
    ASSERT_EQ(areas.document.layers.size(), 2u);
    const Layer& colors = areas.document.layers[0];
    EXPECT_EQ(colors.id, "colors");
    EXPECT_GE(colors.paths.size(), 2u);
    EXPECT_LE(colors.paths.size(), 3u);
    for (const Path& path : colors.paths) {
        EXPECT_EQ(path.look.width, 0.0);
        EXPECT_EQ(path.look.opacity, 1.0);
    }
    style.color.shading = style::Shading::flat;
    const Drawing flat = drawing_of(Colors::areas, true);
    ASSERT_EQ(flat.document.layers[0].paths.size(), 1u);
    EXPECT_EQ(flat.document.layers[0].paths[0].curves.size(), 1u);
    EXPECT_LE(flat.document.layers[0].paths[0].curves[0].points.size(), 13u);
}
