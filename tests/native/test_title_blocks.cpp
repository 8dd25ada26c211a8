// SPDX-License-Identifier: GPL-3.0-or-later
// Title blocks of sheets of paper: where they lie, what they say, and how it is written.
#include <gtest/gtest.h>

#include <fovea/vector/file.h>
#include <fovea/vector/text.h>
#include <fovea/vector/title_block.h>

#include "refused.h"
#include "vector_drawings.h"

using namespace fovea;
using namespace fovea::draw;
using namespace fovea::vector_drawings;

namespace {

constexpr vector::Sheet sheets[] = {vector::Sheet::a0, vector::Sheet::a1, vector::Sheet::a2,    vector::Sheet::a3,
                                    vector::Sheet::a4, vector::Sheet::a5, vector::Sheet::letter};

/// A rectangle.
struct Rectangle {
    dvec2 lower, upper;

    bool holds(const Rectangle& other) const {
        constexpr double off = 1e-9;
        return glm::all(glm::greaterThanEqual(other.lower, lower - off)) &&
               glm::all(glm::lessThanEqual(other.upper, upper + off));
    }
    double common_area(const Rectangle& other) const {
        const dvec2 side = glm::max(glm::min(upper, other.upper) - glm::max(lower, other.lower), dvec2(0.0));
        return side.x * side.y;
    }
    double area() const { return common_area(*this); }
};

Rectangle box_of(const vector::Path& path) {
    Rectangle box{dvec2(1e9), dvec2(-1e9)};
    for (const dvec2& p : path.curves.at(0).points) box = {glm::min(box.lower, p), glm::max(box.upper, p)};
    return box;
}

View view_of(int width, int height) {
    View view;
    view.width = width, view.height = height;
    view.reference_scale = height / 1080.0;
    return view;
}

/// The layers of a page's title block; `options` say which sheet.
std::vector<vector::Layer> layers(const vector::Page& page, const vector::Options& options) {
    return vector::title_block_layers(page, options, "1:50", dvec3(0.0));
}

/// The cube from above, its sides a quarter of the picture's, with a title block on A3.
vector::Drawing from_above(vector::Options options, double page = 210.0, bool orthographic = true,
                           double pixel_aspect = 1.0) {
    Job job = cube(tool::style_of({"contour", "crease"})).job;
    job.style.paper.height_mm = page;
    job.view.orthographic = orthographic;
    job.view.world_to_view = dmat4({1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 0}, {-0.5, -0.5, -9, 1});
    job.view.view_to_clip = dmat4({0.5 * pixel_aspect, 0, 0, 0}, {0, 0.5, 0, 0}, {0, 0, -0.02, 0}, {0, 0, -1, 1});
    if (!orthographic) job.view.view_to_clip = dmat4({4, 0, 0, 0}, {0, 4, 0, 0}, {0, 0, -1, -1}, {0, 0, -0.2, 0});
    options.sheet = vector::Sheet::a3;
    options.title_block = true;
    Frame frame(std::move(job));
    return vector::compose(frame, options);
}

/// What a drawing's title block says in a cell.
std::string said(const vector::Drawing& drawing, const std::string& cell) {
    for (const vector::Caption& caption : drawing.document.layers.back().captions)
        if (caption.id == "title-block-" + cell) return caption.text;
    return "";
}

bool contains(const std::string& text, const std::string& part) { return text.find(part) != text.npos; }

}  // namespace

TEST(TitleBlocks, LieInTheLowerRightCornerOfTheFrameAndThePictureLiesInItBesideOrAbove) {
    for (const vector::Sheet sheet : sheets)
        for (const double margin : {0.0, 5.0, 10.0, 17.5})
            for (const auto& [width, height] : {std::pair(1920, 1080), {1080, 1920}, {500, 500}, {3000, 300}}) {
                const vector::Options options{.sheet = sheet, .margin = margin, .title_block = true};
                const vector::Page page = vector::page_of(view_of(width, height), {}, options);
                const Rectangle space{dvec2(margin), page.size - margin};
                const std::vector<vector::Layer> made = layers(page, options);
                const Rectangle block = box_of(made.at(0).paths.at(1));
                const Rectangle picture{page.lower, page.place(dvec2(width, height))};
                EXPECT_TRUE(space.holds(block) && space.holds(picture)) << int(sheet) << " " << margin;
                EXPECT_EQ(dvec2(block.upper.x, block.lower.y), dvec2(space.upper.x, space.lower.y));
                EXPECT_LE(block.upper.x - block.lower.x, 180.0 + 1e-9);
                EXPECT_NEAR(block.common_area(picture), 0.0, 1e-6) << int(sheet) << " " << margin;
                // It is as large as it can be in the larger of both rooms.
                const dvec2 size = picture.upper - picture.lower, block_size = block.upper - block.lower;
                const auto fits = [&](const dvec2& room) { return std::min(room.x / size.x, room.y / size.y); };
                const dvec2 room = space.upper - space.lower;
                EXPECT_NEAR(std::max(fits({room.x, room.y - block_size.y}), fits({room.x - block_size.x, room.y})), 1.0,
                            1e-9);
            }
}

TEST(TitleBlocks, AreCoveredByTheirCellsWithoutOverlap) {
    for (const double width : {110.0, 128.0, 180.0}) {
        const vector::Options options{.sheet = vector::Sheet::a5};
        const auto cells = vector::title_cells({3.0, 4.0}, width, options, "1:50");
        const Rectangle block{dvec2(3.0, 4.0), dvec2(3.0 + width, 34.0)};
        double area = 0.0;
        for (std::size_t i = 0; i < cells.size(); ++i) {
            const Rectangle cell{cells[i].lower, cells[i].lower + cells[i].size};
            EXPECT_TRUE(block.holds(cell)) << cells[i].name;
            area += cell.area();
            for (std::size_t k = 0; k < i; ++k)
                EXPECT_NEAR(cell.common_area({cells[k].lower, cells[k].lower + cells[k].size}), 0.0, 1e-9);
            EXPECT_EQ(vector::fitted(cells[i].label, vector::least_letters, cell.upper.x - cell.lower.x - 2.0).text,
                      cells[i].label);
        }
        EXPECT_NEAR(area, block.area(), 1e-9);
        EXPECT_EQ(cells.size(), 11u);
    }
}

TEST(TitleBlocks, RuleEachLineBetweenTwoCellsOnce) {
    const vector::Options options{.sheet = vector::Sheet::a4, .title_block = true};
    const vector::Page page = vector::page_of(view_of(1920, 1080), {}, options);
    const std::vector<vector::Layer> made = layers(page, options);
    double length = 0.0, inner = 0.0;
    for (const vector::Path& path : made.at(1).paths) {
        EXPECT_EQ(path.look.width, 0.35);
        length += vector::length_of(path.curves.at(0).points);
    }
    // Sides of all cells, less the outline of the block: each line between two cells is a side of both.
    for (const vector::TitleCell& cell : vector::title_cells(dvec2(0.0), 180.0, options, ""))
        inner += 2.0 * (cell.size.x + cell.size.y);
    EXPECT_NEAR(2.0 * length, inner - 2.0 * (180.0 + 30.0), 1e-9);
    for (const vector::Path& path : made.at(0).paths) EXPECT_EQ(path.look.width, 0.7);
}

TEST(TitleBlocks, NeedASheetThatIsLargeEnough) {
    const auto refusal = [](const vector::Options& options) {
        return refused([&] { vector::page_of(view_of(1080, 1920), {}, options); });
    };
    EXPECT_TRUE(contains(refusal({.title_block = true}), "lies on a sheet of paper: choose one"));
    EXPECT_TRUE(contains(refusal({.sheet = vector::Sheet::pixels, .title_block = true}), "choose one"));
    EXPECT_EQ(refusal({.sheet = vector::Sheet::a5, .margin = 19.0, .title_block = true}), "");
    EXPECT_EQ(refusal({.sheet = vector::Sheet::a5, .margin = 20.0, .title_block = true}),
              "vectors: a title block is at least 110 mm wide and 30 mm high, and within its margins this paper has "
              "108 x 170 mm: take larger paper or a smaller margin");
    EXPECT_TRUE(contains(refusal({.sheet = vector::Sheet::a5, .margin = 80.0, .title_block = true}), "leaves no room"));
}

TEST(TitleBlocks, SayTheScaleThatIsDrawn) {
    for (const double page : {50.0, 210.0 / 3.0, 123.4})
        for (const bool to_scale : {false, true})
            for (const double unit : {1.0, 0.01}) {
                const vector::Drawing drawing = from_above({.to_scale = to_scale, .unit_meters = unit}, page);
                Rectangle drawn{dvec2(1e9), dvec2(-1e9)};
                vector::for_each_path(drawing.document.layers[0].layers, [&](const vector::Path& path) {
                    const Rectangle box = box_of(path);
                    drawn = {glm::min(drawn.lower, box.lower), glm::max(drawn.upper, box.upper)};
                });
                const std::string scale = said(drawing, "scale");
                const std::size_t colon = scale.find(':');
                ASSERT_NE(colon, scale.npos) << scale;
                const double ratio = std::stod(scale.substr(colon + 1)) / std::stod(scale.substr(0, colon));
                const dvec2 meters = 1e-3 * ratio * (drawn.upper - drawn.lower);  // of the cube's top
                EXPECT_NEAR(meters.x / unit, 1.0, 2e-3) << scale;
                EXPECT_NEAR(meters.y / unit, 1.0, 2e-3) << scale;
            }
    vector::Page page{dvec2(210.0, 297.0), dvec2(0.0), 1.0, 1.0};
    View view = view_of(200, 100);
    view.orthographic = true;
    const auto of = [&](double units_high, double unit = 1.0) {
        view.view_to_clip = dmat4(1.0);
        view.view_to_clip[0][0] = 1.0 / units_high, view.view_to_clip[1][1] = 2.0 / units_high;
        return vector::scale_text(view, page, unit);
    };
    EXPECT_EQ(of(5.0), "1:50");
    EXPECT_EQ(of(0.1), "1:1");
    EXPECT_EQ(of(0.02), "5:1");
    EXPECT_EQ(of(5.73149), "1:57.31");
    EXPECT_EQ(of(2500.0), "1:25000");
    EXPECT_EQ(of(500.0, 0.001), "1:5");
}

TEST(TitleBlocks, OfPicturesInPerspectiveAndOfPixelsThatAreNotSquareHaveNoScale) {
    EXPECT_NE(said(from_above({}), "scale"), "not to scale");
    EXPECT_EQ(said(from_above({}, 210.0, false), "scale"), "not to scale");
    EXPECT_EQ(said(from_above({}, 210.0, true, 0.5), "scale"), "not to scale");
}

TEST(TitleBlocks, WriteTextAsHighAsItsCellSaysOrAsItFitsAndCutItOffBelow18Millimeters) {
    const auto height = [](const vector::Caption& caption) { return vector::capitals * caption.size; };
    const vector::Caption shown = vector::fitted("Plan", 3.5, 50.0);
    EXPECT_EQ(shown.text, "Plan");
    EXPECT_NEAR(height(shown), 3.5, 1e-12);
    const std::string word = "Grundriss des Erdgeschosses mit";
    const vector::Caption shrunk = vector::fitted(word, 3.5, 75.0);
    EXPECT_EQ(shrunk.text, word);
    EXPECT_LT(height(shrunk), 3.5);
    EXPECT_GE(height(shrunk), 1.8);
    for (const std::string letter : {"a", "W", "\xc3\x84", "\xe5\x9b\xb3", "\xf0\x9f\x98\x80"}) {
        std::string longer;
        for (int i = 0; i < 300; ++i) longer += letter;
        const vector::Caption cut = vector::fitted(longer, 3.5, 75.0);
        EXPECT_NEAR(height(cut), 1.8, 1e-12);
        ASSERT_GT(cut.text.size(), 3u);
        const std::string kept = cut.text.substr(0, cut.text.size() - 3);
        EXPECT_EQ(cut.text.substr(kept.size()), "...");
        EXPECT_EQ(longer.substr(0, kept.size()), kept);
        EXPECT_EQ(kept.size() % letter.size(), 0u) << "letters are whole";
        EXPECT_GT(kept.size(), 20u * letter.size());
    }
    EXPECT_EQ(vector::fitted("", 3.5, 10.0).text, "");
    EXPECT_EQ(vector::fitted("a\nb\xff", 2.5, 50.0).text, "a?b?");
}

TEST(TitleBlocks, AreWrittenAsTextInEveryFormatAndTheSameTwice) {
    vector::Options options{.titles = {.title = "Ä <&> 图 100% \\U+0041 ^", .number = "A-101"}};
    const auto file = [&](vector::Kind kind) {
        return vector::bytes_of(from_above(vector::fitting(kind, options)).document, kind);
    };
    for (const vector::Kind kind : {vector::Kind::svg, vector::Kind::pdf, vector::Kind::dxf})
        EXPECT_EQ(file(kind), file(kind));
    const std::string svg = file(vector::Kind::svg), dxf = file(vector::Kind::dxf), pdf = file(vector::Kind::pdf);
    EXPECT_TRUE(contains(svg, ">Ä &lt;&amp;&gt; 图 100% \\U+0041 ^</text>"));
    EXPECT_TRUE(contains(svg, "id=\"title-block\" inkscape:groupmode=\"layer\" inkscape:label=\"title block\""));
    EXPECT_TRUE(contains(dxf, "\nTEXT\n"));
    EXPECT_TRUE(contains(dxf, "\n\\U+00C4 <&> \\U+56FE 100% \\U+005CU+0041 ^ \n"));
    EXPECT_TRUE(contains(dxf, "\nTITLE_BLOCK\n"));
    EXPECT_TRUE(contains(pdf, "/Helvetica"));
}

TEST(TitleBlocks, AreOffUnlessAskedForAndOthersSayWhatTheyAreGiven) {
    const vector::Drawing drawing = from_above({.titles = {.title = "Plan", .sheet = "2/3"}});
    EXPECT_EQ(said(drawing, "title"), "Plan");
    EXPECT_EQ(said(drawing, "sheet"), "2/3");
    EXPECT_EQ(said(drawing, "size"), "A3");
    EXPECT_EQ(said(drawing, "owner"), "");
    EXPECT_EQ(said(drawing, "owner-label"), "Legal Owner");
    const auto svg = [](const vector::Options& options) {
        return vector::bytes_of(drawn(tool::style_of({"contour"}), options).document, vector::Kind::svg);
    };
    EXPECT_EQ(svg({.titles = {.title = "Plan"}}), svg({}));
    EXPECT_FALSE(contains(svg({}), "<text"));
}

TEST(TitleBlocks, ForAPlotterAreTwoPensOfLinesWithoutText) {
    const vector::Drawing plot = from_above({.plotter = true});
    const std::vector<vector::Layer>& all = plot.document.layers;
    ASSERT_EQ(all.size(), 3u);
    EXPECT_EQ(all[1].label, "2 frame");
    EXPECT_EQ(all[2].label, "3 title block");
    EXPECT_TRUE(all[2].captions.empty());
    EXPECT_EQ(plot.way->lifts, plot.figures.paths);
    EXPECT_FALSE(from_above({}).document.layers.back().captions.empty());
}

TEST(TitleBlocks, AreWhiteOnDarkPaper) {
    const auto color = [](const dvec3& paper) {
        Job job = cube({}).job;
        job.style.paper.color = paper;
        Frame frame(std::move(job));
        const vector::Drawing made = vector::compose(frame, {.sheet = vector::Sheet::a4, .title_block = true});
        EXPECT_EQ(made.document.layers.back().paths.at(0).look.color, made.document.layers.back().captions.at(0).color);
        return made.document.layers.back().captions.at(0).color;
    };
    EXPECT_EQ(color(dvec3(1.0)), dvec3(0.0));
    EXPECT_EQ(color(dvec3(0.01, 0.03, 0.2)), dvec3(1.0));
}
