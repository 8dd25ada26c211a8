// SPDX-License-Identifier: GPL-3.0-or-later
// Drawings as vectors where something is very short, long, many, see-through or empty.
#include <algorithm>
#include <gtest/gtest.h>
#include <locale>
#include <set>

#include <fovea/stroke/strip.h>
#include <fovea/vector/dxf.h>
#include <fovea/vector/file.h>
#include <fovea/vector/text.h>

#include "refused.h"
#include "vector_drawings.h"

using namespace fovea;
using namespace fovea::draw;
using namespace fovea::vector_drawings;

namespace {

style::Style dashed(double width = 2.0) {
    style::Style style = tool::style_of({"contour", "crease"});
    style.line_sets[0].pen.texture = "dashes";
    style.line_sets[0].pen.width = width;
    return style;
}

vector::Drawing colored(bool transparent) {
    style::Style style = tool::style_of({"contour"});
    style.color.shading = style::Shading::flat;
    style.paper.transparent = transparent;
    Job job = cube(style).job;
    job.colors = ColorSources{.surfaces = SceneColor(1), .lights = {}};
    Frame frame(std::move(job));
    return vector::compose(frame, {});
}

struct Grouped : std::numpunct<char> {
    char do_thousands_sep() const override { return '\''; }
    std::string do_grouping() const override { return "\3"; }
};

}  // namespace

TEST(VectorExtremes, DashesShorterThanTwiceTheToleranceAreALine) {
    for (const vector::Path& path : paths_of(drawn(dashed()))) EXPECT_EQ(path.look.dashes.size(), 2u);
    const vector::Drawing coarse = drawn(dashed(), {.tolerance = 10.0});
    EXPECT_GT(coarse.figures.paths, 0u);
    for (const vector::Path& path : paths_of(coarse)) EXPECT_TRUE(path.look.dashes.empty());
    EXPECT_LT(drawn(dashed(), {.tolerance = 10.0, .dashes_apart = true}).figures.paths, 100u);
}

TEST(VectorExtremes, DashesOfNextToNoLengthAreALineWithoutATolerance) {
    for (const double scale : {1.0, 0.01}) {
        style::Style style = dashed(0.01);
        style.line_sets[0].pen.length_scale = scale;
        const vector::Drawing fine = drawn(style, {.tolerance = 0.0, .dashes_apart = true});
        EXPECT_GT(fine.figures.paths, 0u) << scale;
        EXPECT_LT(fine.figures.paths, 100u) << scale;
        for (const vector::Path& path : paths_of(fine)) EXPECT_TRUE(path.look.dashes.empty()) << scale;
    }
}

TEST(VectorExtremes, DashesApartAreAsLongAsTheyAreInThePattern) {
    const vector::Drawing apart = drawn(dashed(), {.dashes_apart = true});
    EXPECT_GT(apart.figures.paths, 100u);
    const std::vector<double> pattern = paths_of(drawn(dashed())).at(0).look.dashes;
    double longest = 0.0;
    for (const vector::Path& path : paths_of(apart)) {
        ASSERT_EQ(path.curves.size(), 1u);
        longest = std::max(longest, vector::length_of(path.curves[0].points));
    }
    EXPECT_NEAR(longest, pattern.at(0), 1e-3);
}

TEST(VectorExtremes, ForAPlotterDashesStayApartHoweverShortTheirGapsAre) {
    // Gaps of .06 mm, less than that between ends of lines that are joined.
    const vector::Drawing plot = drawn(dashed(0.1), {.plotter = true});
    const std::vector<double> pattern = paths_of(drawn(dashed(0.1))).at(0).look.dashes;
    EXPECT_LT(pattern.at(1), 0.1);
    EXPECT_GT(double(plot.figures.paths), 0.5 * plot.way->pen_down_mm / pattern.at(0));
}

TEST(VectorExtremes, ColorsOnTransparentPaperAreSeeThrough) {
    const vector::Document document = colored(true).document;
    ASSERT_TRUE(document.image);
    EXPECT_FALSE(document.paper);
    EXPECT_EQ(document.image->channels, 4);
    std::set<int> alphas;
    for (std::size_t i = 3; i < document.image->values.size(); i += 4) alphas.insert(document.image->values[i]);
    EXPECT_EQ(*alphas.begin(), 0);
    EXPECT_EQ(*alphas.rbegin(), 255);
    const std::string pdf = vector::bytes_of(document, vector::Kind::pdf);
    EXPECT_NE(pdf.find("/SMask 6 0 R"), pdf.npos);
    EXPECT_NE(pdf.find("/DeviceGray"), pdf.npos);
    // The head of a PNG with 8 bits of red, green, blue and alpha, from its 25th byte on (a third of 24 are 8 letters).
    const std::string svg = vector::bytes_of(document, vector::Kind::svg);
    const std::size_t png = svg.find("base64,") + 7;
    EXPECT_EQ(svg.substr(png + 32, 3), vector::base64("\x08\x06\x00").substr(0, 3));
    EXPECT_EQ(colored(false).document.image->channels, 3);
}

TEST(VectorExtremes, LayersOfPlottersAreNumberedWithoutEmptyOnes) {
    style::Style style = tool::style_of({"border"});  // which a cube has none of
    style.line_sets[0].name = "none";
    style.line_sets.push_back(tool::style_of({"crease"}).line_sets[0]);
    style.line_sets[1].name = "edges";
    const vector::Drawing plot = drawn(style, {.plotter = true});
    ASSERT_EQ(plot.document.layers.size(), 1u);
    EXPECT_EQ(plot.document.layers[0].label, "1 edges");
    EXPECT_NE(vector::dxf_bytes(plot.document).find("\n1_EDGES\n"), std::string::npos);
}

TEST(VectorExtremes, LongNamesOfLayersAreCutAndUnique) {
    vector::Document document;
    document.size = {10, 10};
    for (const char* end : {"a", "b"}) {
        const std::string name = std::string(300, 'x') + end;
        vector::Path path;
        path.curves = {vector::Curve::through(vector::Points{{0, 0}, {1, 1}}, false)};
        document.layers.push_back({name, name, name, {}, {}});
        document.layers.back().layers.push_back({"inner", "visible", {}, {path}, {}});
    }
    const std::string dxf = vector::dxf_bytes(document), name = std::string(200, 'X') + "_VISIBLE";
    EXPECT_EQ(dxf.find(std::string(201, 'X')), std::string::npos);
    EXPECT_NE(dxf.find("\n" + name + "\n"), std::string::npos);
    EXPECT_NE(dxf.find("\n" + name + "_2\n"), std::string::npos);
}

TEST(VectorExtremes, TolerancesBelowTheGridOfFilesAreNone) {
    style::Style style = tool::style_of({"contour", "crease"});
    style.line_sets[0].pen.pressure = 0.8;
    const auto svg = [&](double tolerance) {
        return vector::bytes_of(drawn(style, {.tolerance = tolerance}).document, vector::Kind::svg);
    };
    EXPECT_EQ(svg(1e-300), svg(0.0));
    EXPECT_EQ(svg(0.0019), svg(0.0));
    EXPECT_NE(refused([&] { svg(10.5); }).find("tolerance is 10.5, outside 0 to 10 mm"), std::string::npos);
}

TEST(VectorExtremes, RefusalsHaveTheirNumbersInNoLocale) {
    const std::locale before = std::locale::global(std::locale(std::locale(), new Grouped));
    const std::string told = refused([] { drawn({}, {.sheet = vector::Sheet::a5, .margin = 1000.0}); });
    std::locale::global(before);
    EXPECT_NE(told.find("margin of 1000 mm"), std::string::npos) << told;
}

TEST(VectorExtremes, TheSuffixOfAFileMayHaveCapitals) {
    EXPECT_EQ(tool::vectors_of("x.SVG"), vector::Kind::svg);
    EXPECT_EQ(tool::vectors_of("x.Pdf"), vector::Kind::pdf);
    EXPECT_EQ(tool::vectors_of("x"), std::nullopt);
}

TEST(VectorExtremes, TheMitreLimitIsTheSameBendForStrokesAndFiles) {
    // Of a bend by the angle b, a mitre is 1 / cos(b / 2) widths long.
    EXPECT_NEAR(stroke::mitre_length, std::sqrt(2.0 / (1.0 + stroke::mitre_limit)), 5e-3);
    EXPECT_NE(vector::bytes_of(drawn(dashed()).document, vector::Kind::svg).find("stroke-miterlimit=\"1.556\""),
              std::string::npos);
}

TEST(VectorExtremes, ComposingAPlotHearsACancel) {
    struct Late : Cancel {  // asks once strokes are made
        bool asked() const override { return shaped; }
        bool shaped = false;
    };
    const auto cancel = std::make_shared<Late>();
    Job job = cube(dashed()).job;
    job.cancel = cancel;
    Frame frame(std::move(job));
    frame.shape();
    cancel->shaped = true;
    EXPECT_THROW(vector::compose(frame, {.plotter = true}), Cancelled);
}

TEST(VectorExtremes, APenOutOfItsRangeIsRefusedWithItsLineSet) {
    style::Style style = tool::style_of({"contour", "crease"});
    style.line_sets[0].name = "edges";
    style.line_sets[0].pen.width = 0.0;
    EXPECT_EQ(refused([&] { drawn(style); }), "line set 'edges': pen.width is 0, outside 0.01 to 1000");
    style.line_sets[0].pen.width = 1.0;
    style.line_sets[0].hidden.push_back({});
    style.line_sets[0].hidden[0].pen.opacity = 2.0;
    EXPECT_EQ(refused([&] { drawn(style); }), "line set 'edges': hidden pen.opacity is 2, outside 0 to 1");
}

TEST(VectorExtremes, AreComposedWithoutDrawingPixels) {
    struct Refusing : CpuBackend {
        Array<vec4> draw(const Frame&) override { throw std::logic_error("pixels"); }
    };
    Job job = cube(dashed()).job;
    job.backend = std::make_shared<Refusing>();
    Frame frame(std::move(job));
    EXPECT_GT(vector::compose(frame, {}).figures.paths, 0u);
}
