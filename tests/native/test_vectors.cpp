// SPDX-License-Identifier: GPL-3.0-or-later
// Frames as documents, and their files.
#include <gtest/gtest.h>
#include <regex>
#include <set>

#include <fovea/vector/file.h>
#include <fovea/vector/svg.h>
#include <fovea/vector/text.h>

#include "refused.h"
#include "vector_drawings.h"

using namespace fovea;
using namespace fovea::draw;
using namespace fovea::vector_drawings;

namespace {

style::Style with_hidden() {
    style::Style style = tool::style_of({"contour", "crease"});
    style.line_sets[0].name = "edges & <corners>";
    style.line_sets[0].hidden.push_back({});
    style.line_sets[0].hidden[0].pen.texture = "dashes";
    return style;
}

/// The cube twice as near as it fits the picture, which is 170 mm wide and high in the middle of the sheet.
vector::Drawing of_a_part(vector::Options options, double pressure = 0.0) {
    style::Style style = with_hidden();
    style.line_sets[0].pen.pressure = pressure;
    options.sheet = vector::Sheet::a4;
    options.margin = 20.0;
    Job job = cube(style).job;
    job.view.view_to_clip = dmat4({2, 0, 0, 0}, {0, 2, 0, 0}, {0, 0, 1, 0}, {0, 0, 0, 1}) * job.view.view_to_clip;
    Frame frame(std::move(job));
    return vector::compose(frame, options);
}

/// How far a drawing's paths reach beyond its picture.
double reach_of(const vector::Drawing& drawing) {
    double most = -1e9;
    for (const vector::Path& path : paths_of(drawing))
        for (const dvec2& point : path.curves.at(0).points) {
            const dvec2 off = glm::abs(point - dvec2(105.0, 148.5)) - 85.0;
            most = std::max({most, off.x, off.y});
        }
    return most;
}

}  // namespace

TEST(Vectors, EndWithTheirInkAtTheBorderOfThePictureAndForAPlotterInIt) {
    const double width = 2.0 * 170.0 / 1080.0, fitted = 0.02;
    EXPECT_NEAR(reach_of(of_a_part({})), 0.5 * width, fitted);
    EXPECT_NEAR(reach_of(of_a_part({.widths = vector::Widths::center}, 0.8)), 0.25 * width, 0.25 * width + fitted);
    EXPECT_LE(reach_of(of_a_part({}, 0.8)), width + fitted);
    EXPECT_NEAR(reach_of(of_a_part({.plotter = true})), 0.0, fitted);
    for (const vector::Path& path : paths_of(of_a_part({})))
        EXPECT_GT(path.look.width, 0.0) << "lines that are cut off are lines";
}

TEST(Vectors, OfACubeAreItsEdgesInLayersForWhatIsVisibleAndHidden) {
    const vector::Drawing cube = drawn(with_hidden());
    ASSERT_EQ(cube.document.layers.size(), 1u);
    const vector::Layer& set = cube.document.layers[0];
    EXPECT_EQ(set.line_set, "edges & <corners>");
    ASSERT_EQ(set.layers.size(), 2u);
    EXPECT_EQ(set.layers[0].label, "hidden");
    EXPECT_EQ(set.layers[1].label, "visible");
    double visible = 0.0;
    for (const vector::Path& path : set.layers[1].paths) {
        EXPECT_EQ(path.invisibility, 0);
        EXPECT_NEAR(path.look.width, 2.0 * 210.0 / 1080.0, 1e-3);
        EXPECT_TRUE(path.look.dashes.empty());
        for (const std::uint8_t cubic : path.curves.at(0).cubic) EXPECT_EQ(cubic, 0);
        visible += vector::length_of(path.curves[0].points);
    }
    Frame frame = ::cube(with_hidden());
    frame.ink();
    double expected = 0.0;
    for (std::size_t r = 0; r < frame.drawn->size(); ++r)
        if (frame.drawn->invisibility[r] == 0) expected += frame.drawn->end_px[r] - frame.drawn->start_px[r];
    EXPECT_NEAR(visible, expected * 210.0 / side, 0.01 * visible);
    EXPECT_NEAR(cube.document.size.x, 210.0, 1e-9);
    EXPECT_NEAR(cube.document.size.y, 210.0, 1e-9);
    for (const vector::Path& path : set.layers[0].paths) {
        EXPECT_GT(path.invisibility, 0);
        EXPECT_EQ(path.look.dashes.size(), 2u);
    }
    EXPECT_EQ(cube.figures.paths, paths_of(cube).size());
    EXPECT_LE(cube.figures.numbers, cube.figures.polyline_numbers);
}

TEST(Vectors, DashesFixedToPathsAreThoseOfThePicture) {
    for (const char* texture : {"dashes", "dots", "dash_dot"}) {
        style::Style style = tool::style_of({"contour", "crease"});
        style.line_sets[0].pen.texture = texture;
        style.line_sets[0].pen.texture_anchor = style::Anchor::path;
        style.line_sets[0].pen.width = 12.0;
        Frame frame = cube(style);
        frame.ink();
        const auto ink_at = [&](const dvec2& mm) {
            const glm::ivec2 px(mm * (side / 210.0));
            return double(frame.passes.lines[std::size_t(px.y) * side + std::size_t(px.x)].a);
        };
        const std::vector<vector::Path> dashes = paths_of(drawn(style));
        ASSERT_GT(dashes.size(), 30u) << texture;
        std::size_t black = 0, gaps = 0, white = 0;
        for (std::size_t i = 0; i < dashes.size(); ++i) {
            const vector::Points& points = dashes[i].curves.at(0).points;
            black += ink_at(0.5 * (points.front() + points.back())) > 0.9;
            EXPECT_TRUE(dashes[i].look.dashes.empty());
            if (i == 0 || dashes[i].id.substr(0, 17) != dashes[i - 1].id.substr(0, 17)) continue;
            const dvec2 end = dashes[i - 1].curves.at(0).points.back(), start = points.front();
            // Caps reach by half a width into gaps, and pixels of the picture are 0.39 mm wide.
            if (glm::distance(end, start) < dashes[i].look.width + 0.8) continue;
            white += ink_at(0.5 * (end + start)) < 0.1;
            ++gaps;
        }
        // All but what is hardly wider than a pixel, as where a dash has just divided.
        EXPECT_GT(double(black), 0.97 * double(dashes.size())) << texture;
        EXPECT_GT(double(white), 0.97 * double(gaps)) << texture;
        EXPECT_GT(gaps, 15u) << texture;
    }
}

TEST(Vectors, DashesFixedToPathsThatAreTooShortToBeSeenAreOneLine) {
    style::Style style = tool::style_of({"contour", "crease"});
    style.line_sets[0].pen.texture = "dashes";
    style.line_sets[0].pen.texture_anchor = style::Anchor::path;
    style.line_sets[0].pen.width = 0.02;
    const std::vector<vector::Path> lines = paths_of(drawn(style));
    EXPECT_GT(lines.size(), 3u);
    EXPECT_LT(lines.size(), 15u);
    for (const vector::Path& line : lines) EXPECT_GT(vector::length_of(line.curves.at(0).points), 10.0);
}

TEST(Vectors, HaveUniqueNamesAndEqualBytesTwice) {
    const std::string svg = vector::svg_bytes(drawn(with_hidden()).document);
    EXPECT_EQ(svg, vector::svg_bytes(drawn(with_hidden()).document));
    std::set<std::string> ids;
    const std::regex id(R"re( id="([^"]*)")re");
    for (std::sregex_iterator found(svg.begin(), svg.end(), id), end; found != end; ++found)
        EXPECT_TRUE(ids.insert((*found)[1]).second) << (*found)[1];
    EXPECT_GT(ids.size(), 10u);
    EXPECT_NE(svg.find("edges &amp; &lt;corners&gt;"), std::string::npos);
    EXPECT_NE(svg.find("width=\"210mm\" height=\"210mm\" viewBox=\"0 0 210 210\""), std::string::npos);
    EXPECT_EQ(svg.find("nan"), std::string::npos);
}

TEST(Vectors, LieOnPaperAsThePictureDoes) {
    const auto size = [](vector::Sheet sheet, int width, int height) {
        Frame frame = cube(tool::style_of({"contour"}), width, height);
        return vector::compose(frame, {.sheet = sheet}).document.size;
    };
    EXPECT_EQ(size(vector::Sheet::a4, 320, 200), dvec2(297.0, 210.0));
    EXPECT_EQ(size(vector::Sheet::a4, 200, 320), dvec2(210.0, 297.0));
    EXPECT_EQ(size(vector::Sheet::letter, 320, 200), dvec2(279.4, 215.9));
    EXPECT_EQ(size(vector::Sheet::pixels, 320, 200), dvec2(320.0, 200.0));
    EXPECT_NEAR(size(vector::Sheet::page, 320, 200).x, 336.0, 1e-9);
    EXPECT_NE(refused([&] { drawn({}, {.sheet = vector::Sheet::a5, .margin = 80.0}); }).find("leaves no room"),
              std::string::npos);
    EXPECT_NE(refused([&] { drawn({}, {.margin = -1.0}); }).find("margin is -1, outside 0 to 1000 mm"),
              std::string::npos);
}

TEST(Vectors, OfStrokesThatTaperAreOutlinesOrLines) {
    style::Style style = tool::style_of({"contour", "crease"});
    style.line_sets[0].pen.pressure = 0.8;
    for (const vector::Path& path : paths_of(drawn(style))) EXPECT_EQ(path.look.width, 0.0);
    for (const vector::Path& path : paths_of(drawn(style, {.widths = vector::Widths::center})))
        EXPECT_GT(path.look.width, 0.1);
}

TEST(Vectors, OfAPenThinnerThanAPixelHaveItsWidth) {
    style::Style style = tool::style_of({"contour", "crease"});
    style.line_sets[0].pen.width = 0.5;
    for (const vector::Path& path : paths_of(drawn(style))) {
        EXPECT_NEAR(path.look.width, 0.5 * 210.0 / 1080.0, 1e-3);
        EXPECT_EQ(path.look.opacity, 1.0);
    }
}

TEST(Vectors, OfAPenInMillimetersAreAsWideOnEveryPageAndThoseOfOthersGrowWithThePicture) {
    style::Style style = tool::style_of({"contour", "crease"});
    const auto width = [&](const vector::Options& options) { return paths_of(drawn(style, options)).at(0).look.width; };
    EXPECT_GT(width({.sheet = vector::Sheet::a2}), 1.5 * width({.sheet = vector::Sheet::a4}));
    style.line_sets[0].pen.width_unit = style::WidthUnit::millimetres;
    style.line_sets[0].pen.width = 0.35;
    for (const auto sheet : {vector::Sheet::page, vector::Sheet::a2, vector::Sheet::a5})
        for (const bool plotter : {false, true}) EXPECT_NEAR(width({.sheet = sheet, .plotter = plotter}), 0.35, 1e-6);
    EXPECT_NEAR(width({.sheet = vector::Sheet::pixels}), 0.35 * side / 210.0, 1e-6);
}

TEST(Vectors, ForAPlotterAreJoinedInALayerForEachPenAndDashesApart) {
    const vector::Drawing plot = drawn(with_hidden(), {.plotter = true});
    ASSERT_EQ(plot.document.layers.size(), 2u);
    EXPECT_EQ(plot.document.layers[0].label, "1 edges & <corners> hidden");
    EXPECT_EQ(plot.document.layers[1].label, "2 edges & <corners>");
    EXPECT_LE(plot.document.layers[1].paths.size(), 3u);  // three faces
    EXPECT_GT(plot.document.layers[0].paths.size(), 10u);
    ASSERT_TRUE(plot.way);
    double down = 0.0;
    for (const vector::Path& path : paths_of(plot)) {
        EXPECT_TRUE(path.look.dashes.empty());
        down += vector::length_of(path.curves.at(0).points);
    }
    EXPECT_NEAR(plot.way->pen_down_mm, down, 1e-6);
    EXPECT_EQ(plot.way->lifts, plot.figures.paths);
    EXPECT_LE(plot.way->pen_up_mm, 1.1 * plot.way->pen_up_nearest_mm);
    EXPECT_FALSE(plot.document.paper);
}

TEST(Vectors, OfLinesThatElisionLeavesOutAreNone) {
    style::Style style = tool::style_of({"contour", "crease"});
    style.line_sets[0].pen.opacity = 0.0;
    const vector::Drawing nothing = drawn(style);
    EXPECT_EQ(nothing.figures.paths, 0u);
    EXPECT_TRUE(nothing.document.layers.empty());
    EXPECT_NE(vector::svg_bytes(nothing.document).find("</svg>"), std::string::npos);
}

TEST(Vectors, OfEveryKindHaveAllPathsAndEqualBytesTwice) {
    const auto count = [](const std::string& text, const std::string& word) {
        std::size_t found = 0;
        for (std::size_t at = text.find(word); at != text.npos; at = text.find(word, at + 1)) ++found;
        return found;
    };
    const auto of = [](vector::Kind kind) { return drawn(with_hidden(), vector::fitting(kind, {})); };
    const vector::Drawing lines = of(vector::Kind::dxf);
    const std::string dxf = vector::bytes_of(lines.document, vector::Kind::dxf);
    EXPECT_EQ(count(dxf, "\nLWPOLYLINE\n") + count(dxf, "\nSPLINE\n"), lines.figures.paths);
    EXPECT_EQ(count(dxf, "\nEDGES____CORNERS__VISIBLE\n"), count(dxf, "VISIBLE"));
    EXPECT_EQ(dxf, vector::bytes_of(of(vector::Kind::dxf).document, vector::Kind::dxf));
    const std::string pdf = vector::bytes_of(of(vector::Kind::pdf).document, vector::Kind::pdf);
    EXPECT_EQ(pdf, vector::bytes_of(of(vector::Kind::pdf).document, vector::Kind::pdf));
    EXPECT_EQ(count(pdf, "/Type /OCG"), 3u);
    EXPECT_EQ(pdf.rfind("%PDF-1.5\n", 0), 0u);
    EXPECT_EQ(vector::kind_of("svg"), vector::Kind::svg);
    EXPECT_EQ(vector::kind_of("png"), std::nullopt);
}

TEST(VectorText, OfNumbersIsShortAndHasNoMinusZero) {
    using namespace fovea::vector;
    EXPECT_EQ(number(0.0), "0");
    EXPECT_EQ(number(-0.0001), "0");
    EXPECT_EQ(number(-0.25), "-.25");
    EXPECT_EQ(number(12.3456), "12.346");
    EXPECT_EQ(number(100.0), "100");
    EXPECT_EQ(hexadecimal(0xfeed), "000000000000feed");
    EXPECT_EQ(hex_color(1.0, 0.5, 0.0), "#ff8000");
    EXPECT_EQ(xml("a<b> & \"c\" \x01 \xff \xc3\xa4"), "a&lt;b&gt; &amp; &quot;c&quot; ? ? \xc3\xa4");
    EXPECT_EQ(base64("any carnal pleas"), "YW55IGNhcm5hbCBwbGVhcw==");
    EXPECT_EQ(base64("any carnal pleasu"), "YW55IGNhcm5hbCBwbGVhc3U=");
    EXPECT_EQ(base64("any carnal pleasur"), "YW55IGNhcm5hbCBwbGVhc3Vy");
}
