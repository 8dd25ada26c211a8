// SPDX-License-Identifier: GPL-3.0-or-later
// Passes of lines: together they are the picture's lines, and each says what it shall of them.
#include <bit>
#include <gtest/gtest.h>
#include <set>
#include <tbb/global_control.h>

#include <fovea/draw/cryptomatte.h>
#include <fovea/draw/frame.h>
#include <fovea/stroke/shares.h>
#include <fovea/style/json.h>
#include <fovea/visibility/depth_image.h>

#include "drawing.h"

using namespace fovea;
using namespace fovea::draw;
using namespace fovea::drawing;

namespace {

const std::string contours = R"({"name": "contours", "kinds": {"contour": {}}, "least_length": 0)";
const std::string creases = R"({"name": "creases", "kinds": {"crease": {}}, "least_length": 0)";
const std::string hidden = R"(, "hidden": [{"pen": {"width": 2}}])";

std::string style_of(const std::string& pen, const std::string& other) {
    const auto set = [](const std::string& begin, const std::string& drawn) {
        return begin + R"(, "pen": )" + drawn + hidden + "}";
    };
    return R"({"schema": 1, "line_sets": [)" + set(contours, pen) + ", " + set(creases, other) + "]}";
}

const Options all{
    .with_hidden = true, .with_line_sets = true, .with_line_depth = true, .with_line_id = true, .matte_ranks = 4};
const std::string thick = R"({"width": 9})", faint = R"({"width": 9, "opacity": 0.4})";

/// Two boxes that hide each other in part, "A" before "B".
struct Boxes {
    const Array<Index> numbers{0, 1};

    Job job(const std::string& json, const Options& options = all) const {
        Job job{.scene = std::make_shared<Scene>(Scene(
                    {place(meshes::box(), moved({0, 0, 0}), 1), place(meshes::box(), moved({1.5, 2.5, 0.3}), 2)})),
                .view = perspective({3, -8, 4}, {0, 1, 0}, 50, 240, 180),
                .style = style::read_style(json),
                .options = options,
                .assets = std::make_shared<Assets>("."),
                .backend = std::make_shared<CpuBackend>()};
        job.overrides.objects = {{"A"}, {"B"}};
        job.overrides.names = {"A", "B"};
        job.overrides.objects_of_placement = numbers;
        return job;
    }

    Picture picture(const std::string& json, const Options& options = all) const {
        Frame frame(job(json, options));
        frame.picture();
        return std::move(frame.passes);
    }
};

/// Hidden lines, and the line sets over them, in their order.
Array<vec4> composed(const LinePasses& passes) {
    Array<vec4> made = passes.hidden;
    for (const auto& [name, layer] : passes.line_sets)
        for (std::size_t i = 0; i < made.size(); ++i) made[i] = layer[i] + made[i] * (1.0f - layer[i].a);
    return made;
}

float largest_difference(const Array<vec4>& one, const Array<vec4>& other, bool alpha_alone = false) {
    float most = 0.0f;
    for (std::size_t i = 0; i < one.size(); ++i)
        for (int k = alpha_alone ? 3 : 0; k < 4; ++k) most = std::max(most, std::abs(one[i][k] - other[i][k]));
    return most;
}

struct EdgePoint {
    dvec2 px;
    double depth;
};

/// Points close together on the edges of a box from -1 to 1.
std::vector<EdgePoint> edge_points(const View& view) {
    std::vector<EdgePoint> points;
    for (int axis = 0; axis < 3; ++axis)
        for (const double side : {-1.0, 1.0})
            for (const double other_side : {-1.0, 1.0})
                for (double along = -1.0; along <= 1.0; along += 1.0 / 128.0) {
                    dvec3 at;
                    at[axis] = along, at[(axis + 1) % 3] = side, at[(axis + 2) % 3] = other_side;
                    points.push_back({pixel_of(view, at), -(view.world_to_view * dvec4(at, 1.0)).z});
                }
    return points;
}

}  // namespace

TEST(LinePasses, LineSetsOverHiddenLinesAreThePicturesLinesWherePensHaveOneColor) {
    for (const std::string& pen : {thick, faint}) {
        const Picture picture = Boxes().picture(style_of(pen, pen));
        ASSERT_EQ(picture.of_lines.line_sets.size(), 2u);
        EXPECT_LT(largest_difference(composed(picture.of_lines), picture.lines), 1e-6f);
    }
}

TEST(LinePasses, LineSetsOfTwoColorsHaveTheAlphaOfThePictureAndItsColorsWhereOnlyOneOfThemHasInk) {
    const Picture picture = Boxes().picture(style_of(R"({"width": 9, "color": [1, 0, 0]})", thick));
    const Array<vec4> made = composed(picture.of_lines);
    EXPECT_LT(largest_difference(made, picture.lines, true), 1e-6f);
    const Array<vec4>& one = picture.of_lines.line_sets[0].second;
    const Array<vec4>& other = picture.of_lines.line_sets[1].second;
    std::size_t alone = 0;
    for (std::size_t i = 0; i < made.size(); ++i) {
        if (one[i].a > 0.0f && other[i].a > 0.0f) continue;
        alone += one[i].a > 0.0f || other[i].a > 0.0f;
        EXPECT_LT(glm::length(made[i] - picture.lines[i]), 1e-6f);
    }
    EXPECT_GT(alone, 1000u);
}

TEST(LinePasses, SetsOfOneNameShareAPass) {
    std::string json = style_of(thick, thick);
    json.replace(json.find("creases"), 7, "contours");
    const Picture picture = Boxes().picture(json);
    ASSERT_EQ(picture.of_lines.line_sets.size(), 1u);
    EXPECT_LT(largest_difference(composed(picture.of_lines), picture.lines), 1e-6f);
}

TEST(LinePasses, DepthIsTheDistanceOfTheEdgeThatIsDrawnThereAndThatOfTheBackgroundWhereThereIsNoInk) {
    for (const bool parallel : {false, true}) {
        Job job = Boxes().job(R"({"schema": 1, "line_sets": [{"kinds": {"crease": {}}, "pen": {"width": 2}}]})",
                              {.with_line_depth = true});
        job.overrides = {};
        job.scene = std::make_shared<Scene>(Scene({place(meshes::box(vec3(-1.0f), vec3(1.0f)))}));
        if (parallel) job.view = orthographic({3, -8, 4}, {0, 1, 0}, 8, 240, 180);
        const std::vector<EdgePoint> edges = edge_points(job.view);
        Frame frame(std::move(job));
        frame.picture();
        std::size_t ink = 0;
        for (int y = 0; y < 180; ++y)
            for (int x = 0; x < 240; ++x) {
                const float depth = frame.passes.of_lines.depth[y * 240 + x], alpha = frame.passes.lines[y * 240 + x].a;
                EXPECT_EQ(depth < background_depth, alpha > 0.0f);
                if (alpha == 0.0f) continue;
                ++ink;
                EXPECT_TRUE(std::ranges::any_of(edges,
                                                [&](const EdgePoint& point) {
                                                    return glm::distance(point.px, dvec2(x + 0.5, y + 0.5)) < 2.5 &&
                                                           std::abs(point.depth - depth) < 0.05;
                                                }))
                    << x << ", " << y << ": " << depth;
            }
        EXPECT_GT(ink, 500u);
    }
}

TEST(LinePasses, AnIdIsOneOfALineAndThereIsOneWhereThereIsInk) {
    const Boxes boxes;
    Frame frame(boxes.job(style_of(thick, thick)));
    frame.picture();
    std::set<float> found;
    for (std::size_t i = 0; i < frame.passes.lines.size(); ++i) {
        const float id = frame.passes.of_lines.id[i];
        EXPECT_EQ(id > 0.0f, frame.passes.lines[i].a > 0.0f);
        EXPECT_TRUE(id == std::floor(id) && id < float(1 << 24));
        if (id > 0.0f) found.insert(id);
    }
    std::set<std::uint64_t> paths(frame.paths->id.begin(), frame.paths->id.end());
    EXPECT_GT(found.size(), 8u);
    EXPECT_LE(found.size(), paths.size());
}

TEST(LinePasses, MattesAddUpToTheInkAndTellObjectsApart) {
    const Picture picture = Boxes().picture(style_of(thick, faint));
    ASSERT_EQ(picture.of_lines.mattes.size(), 2u);
    const float a = std::bit_cast<float>(cryptomatte_id("A")), b = std::bit_cast<float>(cryptomatte_id("B"));
    double of_a = 0.0, of_b = 0.0;
    for (std::size_t i = 0; i < picture.lines.size(); ++i) {
        float sum = 0.0f, before = 1.0f;
        for (const Array<vec4>& ranks : picture.of_lines.mattes)
            for (const vec2 rank : {vec2(ranks[i].x, ranks[i].y), vec2(ranks[i].z, ranks[i].w)}) {
                EXPECT_TRUE(rank.x == a || rank.x == b || (rank.x == 0.0f && rank.y == 0.0f));
                EXPECT_LE(rank.y, before);
                sum += before = rank.y;
                (rank.x == a ? of_a : of_b) += rank.y;
            }
        EXPECT_NEAR(sum, picture.lines[i].a, 1e-6f);
    }
    EXPECT_GT(of_a, 1000.0);
    EXPECT_GT(of_b, 500.0);
}

TEST(LinePasses, AreTheSameWithOneAndManyThreadsAndWhateverElseIsAskedFor) {
    const std::string style = style_of(thick, faint);
    const LinePasses many = Boxes().picture(style).of_lines;
    tbb::global_control one(tbb::global_control::max_allowed_parallelism, 1);
    const LinePasses alone = Boxes().picture(style).of_lines;
    EXPECT_EQ(many.hidden, alone.hidden);
    EXPECT_EQ(many.line_sets, alone.line_sets);
    EXPECT_EQ(many.depth, alone.depth);
    EXPECT_EQ(many.id, alone.id);
    EXPECT_EQ(many.mattes, alone.mattes);
    EXPECT_EQ(Boxes().picture(style, {.with_line_depth = true}).of_lines.depth, many.depth);
    EXPECT_EQ(Boxes().picture(style, {.with_hidden = true}).of_lines.hidden, many.hidden);
    EXPECT_EQ(Boxes().picture(style, {.matte_ranks = 4}).of_lines.mattes, many.mattes);
}

TEST(LinePasses, OfTheSpineTestAreThoseOfItsPicture) {
    Options options = all;
    options.visibility = Visibility::spine;
    const Picture picture = Boxes().picture(style_of(thick, thick), options);
    EXPECT_LT(largest_difference(composed(picture.of_lines), picture.lines), 1e-6f);
    std::size_t ink = 0;
    for (std::size_t i = 0; i < picture.lines.size(); ++i) {
        EXPECT_EQ(picture.of_lines.id[i] > 0.0f, picture.lines[i].a > 0.0f);
        ink += picture.lines[i].a > 0.0f;
    }
    EXPECT_GT(ink, 1000u);
}

TEST(LinePasses, ThatAreOffAreNotMade) {
    Frame frame(Boxes().job(style_of(thick, thick), {}));
    frame.picture();
    const LinePasses& none_of_them = frame.passes.of_lines;
    EXPECT_TRUE(none_of_them.hidden.empty() && none_of_them.line_sets.empty() && none_of_them.depth.empty());
    EXPECT_TRUE(none_of_them.id.empty() && none_of_them.mattes.empty());
    for (const auto& [stage, ms] : frame.stages) EXPECT_NE(stage, "passes");
}

TEST(Shares, OfFragmentsOverOneAnotherAreWhatIsSeenOfEach) {
    stroke::Shares shares({0, 0, 2, 1});
    shares.add(1, 0, 7, 0.5f);
    shares.add(1, 0, 9, 0.5f);
    shares.add(1, 0, 7, 0.5f);
    shares.add(1, 0, 0, 0.5f);
    std::vector<stroke::Share> ranked;
    shares.ranked(1, 0, ranked);
    ASSERT_EQ(ranked.size(), 2u);
    EXPECT_EQ(ranked[0].id, 7u);
    EXPECT_EQ(ranked[0].share, 0.3125f);
    EXPECT_EQ(ranked[1].id, 9u);
    EXPECT_EQ(ranked[1].share, 0.125f);
    shares.ranked(0, 0, ranked);
    EXPECT_TRUE(ranked.empty());
}

TEST(Cryptomatte, HashesNamesAsMurmurHash3Does) {
    EXPECT_EQ(murmur_hash(""), 0u);
    EXPECT_EQ(murmur_hash("hello"), 0x248bfa47u);
    EXPECT_EQ(murmur_hash("Cube"), 0xa8fce865u);
}

TEST(Cryptomatte, IdsAreNormalNumbersAndThoseOfHashesThatAreAlready) {
    EXPECT_EQ(cryptomatte_id("Cube"), murmur_hash("Cube"));
    EXPECT_EQ(cryptomatte_id(""), 1u << 23) << "of a hash of 0, whose exponent is that of zero";
    for (int i = 0; i < 2000; ++i)
        EXPECT_TRUE(std::isnormal(std::bit_cast<float>(cryptomatte_id("Object." + std::to_string(i)))));
}
