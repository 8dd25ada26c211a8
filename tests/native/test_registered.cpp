// SPDX-License-Identifier: GPL-3.0-or-later
// Scans registered by their lines and by the marks of a sheet; sheets; curves of precision and recall; paths of SVG.
#include <cmath>
#include <gtest/gtest.h>
#include <numbers>
#include <random>

#include <fovea/base/sanitizers.h>
#include <fovea/study/measures.h>
#include <fovea/study/precision_recall.h>
#include <fovea/study/register.h>
#include <fovea/study/scan.h>
#include <fovea/study/sheet.h>
#include <fovea/study/svg_path.h>
#include <fovea/study/thin.h>
#include <fovea/vector/pdf.h>

namespace fovea {
namespace {

using namespace study;

/// Polylines, as points and offsets.
struct Polylines {
    std::vector<vec2> px;
    std::vector<std::int64_t> offsets{0};

    void add(const std::vector<dvec2>& line) {
        for (const dvec2& p : line) px.emplace_back(p);
        offsets.push_back(std::int64_t(px.size()));
    }
    Bitmap drawn(int width, int height, const Homography& map = Homography(1.0)) const {
        std::vector<vec2> moved;
        for (const vec2& p : px) moved.emplace_back(mapped(map, dvec2(p)));
        return pixels_of(moved, offsets, width, height);
    }
};

/// A vase with a handle, bands and a crack: no symmetry, one outer boundary.
Polylines vase(double width, double height) {
    Polylines lines;
    const dvec2 middle(0.5 * width, 0.5 * height);
    const double r = 0.38 * height;
    std::vector<dvec2> outline, handle, crack;
    for (int i = 0; i <= 200; ++i) {
        const double t = 2.0 * std::numbers::pi * i / 200;
        const double far =
            r * (1.0 + 0.15 * std::cos(2.0 * t + 0.4) + 0.1 * std::sin(3.0 * t) + 0.05 * std::cos(5.0 * t));
        outline.push_back(middle + far * dvec2(1.25 * std::cos(t), std::sin(t)));
    }
    lines.add(outline);
    for (int band = 0; band < 3; ++band) {
        std::vector<dvec2> line;
        for (int i = 0; i <= 60; ++i) {
            const double x = -0.7 + 1.4 * i / 60;
            line.push_back(middle + r * dvec2(x, -0.5 + 0.4 * band + 0.1 * (band + 1) * std::cos(3.0 * x)));
        }
        lines.add(line);
    }
    for (int i = 0; i <= 40; ++i) {
        const double t = 2.0 + 3.5 * i / 40;
        handle.push_back(middle + r * dvec2(0.55 + 0.22 * std::cos(t), 0.3 + 0.3 * std::sin(t)));
        crack.push_back(middle + r * dvec2(-0.5 + 0.01 * i, -0.2 - 0.012 * i + 0.03 * std::sin(0.7 * i)));
    }
    lines.add(handle);
    lines.add(crack);
    return lines;
}

/// Rotation up to 10 degrees, sizes of 0.8 to 1.25, a perspective of a tenth over the frame, moved up to a twentieth.
Homography random_map(std::mt19937& random, double width, double height) {
    std::uniform_real_distribution<double> unit(-1.0, 1.0);
    const double turn = unit(random) * 10.0 * std::numbers::pi / 180.0, size = std::exp(unit(random) * std::log(1.25));
    const double c = size * std::cos(turn), s = size * std::sin(turn);
    const dvec2 moved = 0.05 * height * dvec2(unit(random), unit(random));
    const Homography similarity(c, s, 0.0, -s, c, 0.0, moved.x, moved.y, 1.0);
    const Homography perspective(1.0, 0.0, 0.1 * unit(random) / width, 0.0, 1.0, 0.1 * unit(random) / width, 0.0, 0.0,
                                 1.0);
    const Homography in(1.0, 0.0, 0.0, 0.0, 1.0, 0.0, -0.5 * width, -0.5 * height, 1.0);
    return glm::inverse(in) * similarity * perspective * in;
}

/// The greatest distance between two maps at the points of lines.
double error_of(const Homography& found, const Homography& truth, const Polylines& lines) {
    double most = 0.0;
    for (const vec2& p : lines.px) most = std::max(most, glm::distance(mapped(found, p), mapped(truth, p)));
    return most;
}

color::GrayImage inked(const Bitmap& bitmap) {
    color::GrayImage picture{bitmap.width, bitmap.height, Array<std::uint8_t>(bitmap.set.size())};
    for (std::size_t i = 0; i < bitmap.set.size(); ++i) picture.values[i] = bitmap.set[i] ? 30 : 255;
    return picture;
}

TEST(Registered, AHomographyIsRecoveredFromFourPoints) {
    std::mt19937 random(1);
    const Homography truth = random_map(random, 1024, 768);
    const std::vector<dvec2> from{{0, 0}, {1024, 10}, {1000, 768}, {20, 700}};
    std::vector<dvec2> to;
    for (const dvec2& p : from) to.push_back(mapped(truth, p));
    const auto found = homography_of(from, to);
    ASSERT_TRUE(found);
    EXPECT_LT(glm::distance(mapped(*found, {512, 300}), mapped(truth, {512, 300})), 1e-6);
    EXPECT_FALSE(homography_of(from, std::vector<dvec2>{{0, 0}, {1, 1}, {2, 2}, {3, 3}}));
}

#ifdef FOVEA_ADDRESS_SANITIZER
constexpr unsigned trials = 5;  // each takes seconds then
#else
constexpr unsigned trials = 50;
#endif

TEST(Registered, EveryRandomHomographyIsRecovered) {
    constexpr int width = 640, height = 480;
    const Polylines lines = vase(width, height);
    const Bitmap reference = lines.drawn(width, height);
    const double tolerance = usual_tolerance(reference.diagonal());
    for (unsigned seed = 0; seed < trials; ++seed) {
        std::mt19937 random(seed);
        const Homography truth = random_map(random, width, height);
        const auto found = registered(lines.drawn(width, height, truth), reference, tolerance);
        ASSERT_TRUE(found);
        EXPECT_LT(error_of(found->to_scan, truth, lines), 0.5) << "seed " << seed;
        EXPECT_GT(found->outer_share, 0.85) << "seed " << seed;  // a part may be outside of the scan
    }
}

TEST(Registered, ADrawingOfSomethingElseDoesNotHaveItsOuterBoundary) {
    Polylines other;
    for (int i = 0; i < 12; ++i) other.add({{100.0 + 60 * i, 100.0}, {400.0 + 10 * i, 600.0 - 20 * i}});
    const Bitmap reference = vase(1024, 768).drawn(1024, 768);
    const auto found = registered(other.drawn(1024, 768), reference, usual_tolerance(reference.diagonal()));
    ASSERT_TRUE(found);
    EXPECT_LT(found->outer_share, 0.9);
    EXPECT_FALSE(registered(Bitmap(10, 10), reference, 5.0));
}

TEST(Registered, TheOuterPixelsOfAShapeAreItsBoundaryAlone) {
    Polylines lines;
    lines.add({{50, 50}, {200, 50}, {200, 150}, {50, 150}, {50, 50}});
    const Bitmap box = lines.drawn(256, 192);
    lines.add({{80, 100}, {170, 100}});
    EXPECT_EQ(outer_pixels(lines.drawn(256, 192), 4.0).set, box.set);
}

/// What a sheet's page looks like on a scan: its picture, box and marks.
color::GrayImage printed(const vector::Document& page, double px_per_mm) {
    const int width = int(page.size.x * px_per_mm), height = int(page.size.y * px_per_mm);
    const vector::Image& image = *page.image;
    color::GrayImage scan{width, height, Array<std::uint8_t>(std::size_t(width) * std::size_t(height))};
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            const dvec2 mm = (dvec2(x, y) + 0.5) / px_per_mm;
            const dvec2 at = (mm - image.lower) / image.size * dvec2(image.width, image.height);
            const bool is_inside = at.x >= 0 && at.y >= 0 && at.x < image.width && at.y < image.height;
            std::uint8_t value = 255;
            if (is_inside) value = image.values[3 * (std::size_t(at.y) * std::size_t(image.width) + std::size_t(at.x))];
            for (const vector::Curve& disc : page.layers[0].paths[1].curves) {
                const dvec2 right = disc.points[0], left = disc.points[6];
                if (glm::distance(mm, 0.5 * (left + right)) < 0.5 * glm::distance(left, right)) value = 20;
            }
            scan.values[std::size_t(y) * std::size_t(width) + std::size_t(x)] = value;
        }
    return scan;
}

TEST(Registered, AScannedSheetIsFoundByItsMarksHoweverItLies) {
    constexpr int width = 512, height = 384;
    const Bitmap drawing = vase(width, height).drawn(width, height);
    const vector::Document page = prompt_sheet(inked(drawing), vector::Sheet::a4, "vase");
    const color::GrayImage scan = printed(page, 3.0);
    for (const double degrees : {0.0, 4.0, 90.0, 183.0}) {
        const double c = std::cos(degrees * std::numbers::pi / 180.0), s = std::sin(degrees * std::numbers::pi / 180.0);
        const int side = 1000;
        // From the pixels of a larger scan to those of this one, about both middles.
        const dvec2 from(0.5 * side), to(0.5 * scan.width, 0.5 * scan.height);
        const Homography turn(c, s, 1e-5, -s, c, 2e-5, to.x - c * from.x + s * from.y, to.y - s * from.x - c * from.y,
                              1.0);
        const auto found = found_by_marks(resampled(scan, turn, side, side), width, height);
        ASSERT_TRUE(found) << degrees;
        const dvec2 size = dvec2(width, height);
        for (const dvec2& p : {dvec2(0.0), dvec2(width, 0.0), dvec2(width, height), dvec2(0.0, height)}) {
            const dvec2 mm =
                page.layers[0].paths[0].curves[0].points[0] +
                p / size * (page.layers[0].paths[0].curves[0].points[2] - page.layers[0].paths[0].curves[0].points[0]);
            EXPECT_LT(glm::distance(mapped(turn, mapped(*found, p)), 3.0 * mm), 1.0) << degrees;
        }
    }
    EXPECT_FALSE(found_by_marks(inked(drawing), width, height));
}

TEST(Registered, EveryRandomHomographyIsRecoveredByMarks) {
    constexpr int width = 512, height = 384;
    const vector::Document page =
        prompt_sheet(inked(vase(width, height).drawn(width, height)), vector::Sheet::a4, "vase");
    const color::GrayImage scan = printed(page, 3.0);
    const vector::Points& box = page.layers[0].paths[0].curves[0].points;
    const Homography out(1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 250.0, 250.0, 1.0);  // paper around the sheet
    for (unsigned seed = 0; seed < trials; ++seed) {
        std::mt19937 random(seed);
        const Homography truth = out * random_map(random, scan.width, scan.height);
        const auto moved = resampled(scan, glm::inverse(truth), scan.width + 500, scan.height + 500);
        const auto found = found_by_marks(moved, width, height);
        ASSERT_TRUE(found) << "seed " << seed;
        for (const dvec2& p : {dvec2(0.0), dvec2(width, 0.0), dvec2(width, height), dvec2(0.5 * width, 0.0)}) {
            const dvec2 share = p / dvec2(width, height), at = 3.0 * (box[0] + share * (box[2] - box[0]));
            EXPECT_LT(glm::distance(mapped(*found, p), mapped(truth, at)), 1.0) << "seed " << seed;
        }
    }
}

TEST(Registered, AScanThatLacksAMarkIsNotRegisteredByOthers) {
    constexpr int width = 512, height = 384;
    const vector::Document page =
        prompt_sheet(inked(vase(width, height).drawn(width, height)), vector::Sheet::a4, "vase");
    for (std::size_t lost = 0; lost < 5; ++lost) {
        vector::Document without = page;
        auto& discs = without.layers[0].paths[1].curves;
        discs.erase(discs.begin() + std::ptrdiff_t(lost));
        EXPECT_FALSE(found_by_marks(printed(without, 3.0), width, height)) << lost;
    }
}

TEST(Registered, ASheetIsAPdfFileWithItsTitle) {
    const vector::Document page = prompt_sheet(inked(vase(128, 96).drawn(128, 96)), vector::Sheet::letter, "vase 1234");
    EXPECT_EQ(page.layers.at(0).captions.at(0).text, "vase 1234");
    EXPECT_NEAR(page.size.x, 215.9, 0.1);
    EXPECT_EQ(vector::pdf_bytes(page).substr(0, 5), "%PDF-");
    EXPECT_NE(vector::pdf_bytes(page).find("/Helvetica"), std::string::npos);
    EXPECT_THROW(prompt_sheet(inked(Bitmap(10, 10)), vector::Sheet::pixels, ""), std::invalid_argument);
}

TEST(PrecisionRecall, ACurveHasTheDrawingsOfAllThresholds) {
    // The judge's line has strength 0.8 on its left half and 0.3 on its right; a wrong one has 0.5.
    Polylines lines, truth;
    truth.add({{0.5, 50.5}, {199.5, 50.5}});
    lines.add({{0.5, 50.5}, {99.5, 50.5}});
    lines.add({{100.5, 50.5}, {199.5, 50.5}});
    lines.add({{0.5, 90.5}, {199.5, 90.5}});
    const std::vector<float> values{0.8f, 0.8f, 0.3f, 0.3f, 0.5f, 0.5f};
    const Strengths strengths{200, 100, most_at_pixels(lines.px, lines.offsets, values, 200, 100)};
    const PrecisionRecall curve = precision_recall(strengths, Bitmap(200, 100), truth.drawn(200, 100), 3.0);
    ASSERT_EQ(curve.threshold.size(), 4u);
    EXPECT_EQ(curve.precision[0], 1.0);
    EXPECT_EQ(curve.recall[0], 0.0);
    EXPECT_EQ(curve.precision[1], 1.0);
    EXPECT_NEAR(curve.recall[1], 103.0 / 200.0, 1e-12);
    EXPECT_NEAR(curve.precision[2], 1.0 / 3.0, 1e-12);
    EXPECT_NEAR(curve.precision[3], 0.5, 1e-12);
    EXPECT_EQ(curve.recall[3], 1.0);
    EXPECT_TRUE(std::ranges::is_sorted(curve.recall));
    EXPECT_NEAR(curve.recall_at(0.8), 103.0 / 200.0, 1e-12);
    EXPECT_EQ(curve.recall_at(0.5), 1.0);
    EXPECT_EQ(curve.threshold[std::size_t(curve.best_at(0.8))], 0.8f);
    EXPECT_NEAR(curve.area(), 103.0 / 200.0, 0.01);
    for (const float threshold : {0.2f, 0.4f, 0.6f, 0.9f}) {
        const Measures found = compare(strengths.above(threshold), truth.drawn(200, 100), 3.0);
        std::size_t i = 0;
        while (i + 1 < curve.threshold.size() && curve.threshold[i + 1] >= threshold) ++i;
        EXPECT_EQ(curve.precision[i], found.precision) << threshold;
        EXPECT_EQ(curve.recall[i], found.recall) << threshold;
    }
}

TEST(PrecisionRecall, ContoursAreDrawnInAnyCase) {
    Polylines contour, other;
    contour.add({{0.5, 20.5}, {199.5, 20.5}});
    other.add({{0.5, 60.5}, {199.5, 60.5}});
    const Strengths none{200, 100, Array<float>(20000, -1.0f)};
    const PrecisionRecall curve = precision_recall(none, contour.drawn(200, 100), other.drawn(200, 100), 3.0);
    ASSERT_EQ(curve.threshold.size(), 1u);
    EXPECT_EQ(curve.precision[0], 0.0);
    EXPECT_EQ(curve.best_at(0.8), -1);
    EXPECT_EQ(curve.recall_at(0.8), 0.0);
}

TEST(SvgPath, EveryCommandGoesWhereSvgSays) {
    const auto end = [](std::string_view data) { return curves_of(data).back().end(); };
    EXPECT_EQ(end("M1 2L3 4"), dvec2(3, 4));
    EXPECT_EQ(end("m1,2 3,4"), dvec2(4, 6));
    EXPECT_EQ(end("M1 2h3v-1"), dvec2(4, 1));
    EXPECT_EQ(end("M1 2H3V-1"), dvec2(3, -1));
    EXPECT_EQ(end("M0 0c1 0 2 1 2 2s1 2 2 2"), dvec2(4, 4));
    EXPECT_EQ(end("M0 0Q1 1 2 0t2 0"), dvec2(4, 0));
    EXPECT_EQ(end("M1.5.5-.5e1"), dvec2(1.5, 0.5)) << "up to the first error";
    EXPECT_EQ(curves_of("M0 0h4v4zM9 9h1").size(), 2u);
    EXPECT_TRUE(curves_of("M0 0h4v4z").front().closed);
    EXPECT_TRUE(curves_of("L1 1").empty());
    EXPECT_TRUE(curves_of("").empty());
}

TEST(SvgPath, AnArcKeepsItsDistanceFromItsCenter) {
    for (const std::string_view data : {"M10 0A10 10 0 0 1 0 10", "M10 0a10 10 0 1 0-10 10", "M10 0A10 10 30 01-10 0"})
        for (const vector::Curve& curve : curves_of(data))
            for (const dvec2& p : vector::flattened(curve, 0.01)) EXPECT_NEAR(glm::length(p), 10.0, 0.01) << data;
}

TEST(SvgPath, AnOutlineIsTheLineInItsMiddle) {
    const std::array<double, 6> upright{1, 0, 0, 1, 0, 0};
    const Bitmap stroke = pixels_of_svg({{"M10 46h180v8h-180z", upright, true}}, 200, 100);
    const Bitmap line = pixels_of_svg({{"M10 50h180", upright, false}}, 200, 100);
    EXPECT_EQ(compare(stroke, line, 2.0).precision, 1.0);
    EXPECT_GT(compare(stroke, line, 4.0).recall, 0.99);
    EXPECT_LT(stroke.count(), 200u);
    // From the upper left corner: 50 from the top is row 50 or 49 from below, and 20 is row 80 or 79.
    EXPECT_TRUE(pixels_of_svg({{"M10 20h180", upright, false}}, 200, 100).set[80 * 200 + 50]);
}

}  // namespace
}  // namespace fovea
