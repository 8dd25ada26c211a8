// SPDX-License-Identifier: GPL-3.0-or-later
// A whole picture: its steps, its styles, and who draws it.
#include <filesystem>
#include <fstream>
#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <fovea/color/png.h>
#include <fovea/draw/frame.h>
#include <fovea/draw/polylines.h>
#include <fovea/elision/elide.h>
#include <fovea/style/json.h>

#include "drawing.h"
#include "refused.h"

using namespace fovea;
using namespace fovea::draw;
using namespace fovea::drawing;

namespace {

/// Two boxes, the one behind half hidden.
std::shared_ptr<const Scene> two_boxes() {
    return std::make_shared<Scene>(
        Scene({place(meshes::box(), moved({0, 0, 0}), 1), place(meshes::box(), moved({1.5, 2.5, 0.3}), 2)}));
}

const char* with_hidden_lines =
    R"({"schema": 1, "line_sets": [{"kinds": {"contour": {}, "crease": {"angle": 40}}, "least_length": 0,
    "pen": {"width": 4}, "hidden": [{"pen": {"width": 2, "color": [1, 0, 0]}}]}]})";

Job job_of(const char* json, const Options& options = {}) {
    return {.scene = two_boxes(),
            .view = perspective({3, -8, 4}, {0, 1, 0}, 50, 240, 180),
            .style = style::read_style(json),
            .options = options,
            .assets = std::make_shared<Assets>("."),
            .backend = std::make_shared<CpuBackend>()};
}

}  // namespace

TEST(Frame, AStepTakesThoseBeforeItAndNoneAfterIt) {
    Frame frame(job_of(with_hidden_lines));
    frame.see();
    EXPECT_TRUE(frame.paths && frame.clipped && frame.visible);
    EXPECT_FALSE(frame.runs || frame.strokes);
    EXPECT_GT(frame.visible->size(), 5u);
    frame.picture();
    EXPECT_EQ(frame.passes.combined.size(), 240u * 180u);
    std::vector<std::string> names;
    for (const auto& [name, ms] : frame.stages) names.push_back(name);
    EXPECT_EQ(names, (std::vector<std::string>{"bvh", "lines", "project", "visibility", "runs", "shape", "strokes",
                                               "focus", "paper"}));
}

TEST(Frame, StoppingInBetweenChangesNoPixel) {
    Frame at_once(job_of(with_hidden_lines)), in_steps(job_of(with_hidden_lines));
    at_once.picture();
    in_steps.find();
    in_steps.filter();
    polylines_of(in_steps);
    in_steps.ink();
    in_steps.picture();
    EXPECT_EQ(at_once.passes.combined, in_steps.passes.combined);
}

TEST(Frame, IsTheSameWithOneAndManyThreads) {
    Frame many(job_of(with_hidden_lines));
    many.picture();
    tbb::global_control one(tbb::global_control::max_allowed_parallelism, 1);
    Frame alone(job_of(with_hidden_lines));
    alone.picture();
    EXPECT_EQ(many.passes.combined, alone.passes.combined);
}

TEST(Frame, DrawsHiddenPartsInThePenOfHiddenPartsAndOnlyThese) {
    Frame frame(job_of(with_hidden_lines));
    frame.ink();
    std::size_t hidden = 0;
    for (const std::uint8_t level : frame.runs->invisibility) hidden += level > 0;
    EXPECT_GT(hidden, 3u);
    ASSERT_EQ(frame.pens.pens.size(), 2u);
    EXPECT_EQ(frame.pens.pens[1].look.color, dvec3(1, 0, 0));
    float red = 0.0f, gray = 0.0f;
    for (const vec4& pixel : frame.passes.lines) (pixel.r > 0.5f * pixel.a ? red : gray) += pixel.a;
    EXPECT_GT(red, 50.0f);
    EXPECT_GT(gray, red);
}

TEST(Frame, PolylinesAreTheRunsOfThePictureWithTheirPens) {
    Frame frame(job_of(with_hidden_lines));
    const Polylines lines = polylines_of(frame);
    ASSERT_EQ(lines.path.size(), frame.runs->size());
    for (std::size_t r = 0; r < lines.path.size(); ++r) {
        EXPECT_EQ(lines.pen[r], lines.invisibility[r] > 0 ? 1u : 0u);
        EXPECT_EQ(lines.shown[r], 1.0f);
    }
}

TEST(Frame, SampledMethodsSeeNearlyWhatRaysSee) {
    const auto length = [](Visibility visibility) {
        Frame frame(job_of(with_hidden_lines, {.visibility = visibility}));
        frame.see();
        double sum = 0.0;
        for (std::size_t r = 0; r < frame.visible->size(); ++r)
            sum += frame.visible->end_px[r] - frame.visible->start_px[r];
        return sum;
    };
    const double exact = length(Visibility::exact);
    EXPECT_NEAR(length(Visibility::atlas), exact, 0.02 * exact);
    EXPECT_NEAR(length(Visibility::item_buffer), exact, 0.05 * exact);
    EXPECT_GT(length(Visibility::spine), exact);
}

TEST(Frame, ABackendOfOnesOwnIsAskedForItsThreeVerbs) {
    struct Counting : CpuBackend {
        int looks = 0, thinned = 0, drawn = 0;
        Array<float> visibility(const Frame& frame) override { return ++looks, CpuBackend::visibility(frame); }
        Array<vec2> elide(const Frame& frame, const Elision& elision) override {
            return ++thinned, CpuBackend::elide(frame, elision);
        }
        Array<vec4> draw(const Frame& frame) override { return ++drawn, CpuBackend::draw(frame); }
    };
    const auto counting = std::make_shared<Counting>();
    Job job = job_of(with_hidden_lines, {.visibility = Visibility::atlas});
    job.style.elision.enabled = true;
    job.backend = counting;
    Frame frame(std::move(job));
    frame.picture();
    EXPECT_EQ(counting->looks, 1);
    EXPECT_EQ(counting->thinned, 1);
    EXPECT_EQ(counting->drawn, 1);
    EXPECT_EQ(frame.shown.size(), frame.clipped->samples);
}

TEST(Frame, CanBeCancelledBeforeItsLinesAreFound) {
    Job job = job_of(with_hidden_lines);
    const auto cancel = std::make_shared<Cancel>();
    cancel->requested = true;
    job.cancel = cancel;
    Frame frame(std::move(job));
    EXPECT_THROW(frame.picture(), Cancelled);
    EXPECT_THROW(frame.see(), Cancelled) << "a step that did not end is not taken for done";
    cancel->requested = false;
    frame.picture();
    Frame fresh(job_of(with_hidden_lines));
    fresh.picture();
    EXPECT_EQ(frame.passes.combined, fresh.passes.combined);
}

TEST(Frame, WithoutWhatAStepNeedsIsRefused) {
    Job job = job_of(with_hidden_lines);
    job.backend = nullptr;
    Frame lines_alone(std::move(job));
    lines_alone.find();
    EXPECT_THROW(lines_alone.strokes_with({}), std::invalid_argument);
    EXPECT_THROW(lines_alone.see(), std::invalid_argument);
    Job nowhere = job_of(with_hidden_lines);
    nowhere.scene = nullptr;
    EXPECT_THROW(Frame(std::move(nowhere)).find(), std::invalid_argument);
}

TEST(Frame, AViewThatShowsNothingIsRefusedInASentenceAboutTheCamera) {
    const auto said = [](const auto& spoil) {
        Job job = job_of(with_hidden_lines);
        spoil(job.view);
        return refused([&] { Frame frame(std::move(job)); });
    };
    const double nan = std::numeric_limits<double>::quiet_NaN(), inf = std::numeric_limits<double>::infinity();
    const auto begins = [](const std::string& sentence) { return sentence.substr(0, 8); };
    EXPECT_EQ(said([](View&) {}), "");
    EXPECT_EQ(said([](View& v) { v.width = 0; }), "camera: its picture has no pixels; make it wider or higher");
    EXPECT_EQ(said([](View& v) { v.far_clip = v.near_clip; }),
              "camera: it sees nothing; set its Clip Start below its Clip End");
    for (const double bad : {nan, inf, 1e300}) {
        EXPECT_EQ(begins(said([&](View& v) { v.world_to_view[3].x = bad; })), "camera: ");
        EXPECT_EQ(begins(said([&](View& v) { v.view_to_clip[0].x = bad; })), "camera: ");
        EXPECT_EQ(begins(said([&](View& v) { v.reference_scale = bad; })), "camera: ");
        EXPECT_EQ(begins(said([&](View& v) { v.frame.z = bad; })), "camera: ");
    }
    for (const double bad : {nan, inf, 0.0, -1.0}) {
        EXPECT_EQ(begins(said([&](View& v) { v.near_clip = bad; })), "camera: ");
        EXPECT_EQ(begins(said([&](View& v) { v.world_to_view[1] *= bad == -1.0 ? 0.0 : bad; })), "camera: ");
        EXPECT_EQ(begins(said([&](View& v) { v.view_to_clip[1] *= bad == -1.0 ? 0.0 : bad; })), "camera: ");
    }
}

TEST(Frame, AnOptionOutOfItsRangeIsNamed) {
    const auto said = [](const Options& options) {
        return refused([&] { Frame frame(job_of(with_hidden_lines, options)); });
    };
    EXPECT_EQ(said({}), "");
    EXPECT_EQ(said({.probes = 17}), "options.probes is 17, outside 1 to 16");
    EXPECT_EQ(said({.depth_scale = 0}), "options.depth_scale is 0, outside 1 to 8");
    EXPECT_EQ(said({.gap = -1.0}), "options.gap is -1, outside 0 to 10000");
    EXPECT_EQ(said({.sample_step = std::numeric_limits<double>::quiet_NaN()}),
              "options.sample_step is nan, outside 0.01 to 1000");
}

TEST(Frame, APictureOfOnePixelIsDrawn) {
    Job job = job_of(with_hidden_lines, {.sample_step = 0.5});
    job.view = perspective({3, -8, 4}, {0, 1, 0}, 50, 1, 1);
    job.view.reference_scale = 1.0 / 1080.0;
    Frame frame(std::move(job));
    frame.picture();
    EXPECT_EQ(frame.passes.combined.size(), 1u);
}

TEST(Style, PensAreNumberedByLineSetThenThoseOfHiddenPartsThenThoseOutOfFocus) {
    const style::Style style = style::read_style(R"({"schema": 1, "line_sets": [
        {"pen": {"width": 1}, "hidden": [{"from": 1, "to": 2, "pen": {"width": 3}, "pen_away": {"width": 6}},
                                         {"from": 5, "pen": {"width": 4}}]},
        {"pen": {"width": 2}, "pen_away": {"width": 5}}]})");
    const Pens pens = pens_of(style, Assets("."), 2.0);
    std::vector<float> widths;
    std::vector<Index> away;
    for (const Pen& pen : pens.pens) {
        widths.push_back(pen.width_px);
        away.push_back(pen.away);
    }
    EXPECT_EQ(widths, (std::vector<float>{2, 4, 6, 8, 10, 12}));
    EXPECT_EQ(away, (std::vector<Index>{none, 4, 5, none, none, none}));
    ASSERT_EQ(pens.ranges.size(), 4u);
    const auto row = [&](int i) {
        const PenRange& r = pens.ranges[i];
        return std::array{r.line_set, r.from, r.to, r.pen};
    };
    EXPECT_EQ(row(1), (std::array<Index, 4>{1, 0, 0, 1}));
    EXPECT_EQ(row(2), (std::array<Index, 4>{0, 1, 2, 2}));
    EXPECT_EQ(row(3), (std::array<Index, 4>{0, 5, 255, 3}));
}

TEST(Style, SurfacesAreCountedAsFarAsPensTellThemApart) {
    const auto counted = [](const std::string& hidden) {
        return style::read_style(R"({"schema": 1, "line_sets": [{}, {"hidden": [)" + hidden + "]}]}").counted();
    };
    EXPECT_EQ(counted(""), 0u);
    EXPECT_EQ(counted("{}"), 1u);
    EXPECT_EQ(counted(R"({"from": 1, "to": 1})"), 2u);
    EXPECT_EQ(counted(R"({"from": 1, "to": 2}, {"from": 3})"), 3u);
    EXPECT_EQ(counted(R"({"from": 4})"), 4u);
    EXPECT_EQ(counted(R"({"from": 2, "to": 5})"), 6u);
}

TEST(Style, WidthsAreInTheUnitOfThePen) {
    const auto width = [](const char* unit) {
        const std::string pen = std::string(R"({"width": 3, "width_unit": ")") + unit + R"("})";
        return pens_of(style::read_style(R"({"schema": 1, "paper": {"height_mm": 270}, "line_sets": [{"pen": )" + pen +
                                         "}]}"),
                       Assets("."), 0.5)
            .pens[0]
            .width_px;
    };
    EXPECT_EQ(width("reference"), 1.5f);
    EXPECT_EQ(width("pixels"), 3.0f);
    EXPECT_EQ(width("millimetres"), 6.0f);  // 540 pixels are 270 mm
}
