// SPDX-License-Identifier: GPL-3.0-or-later
// Pens whose width, opacity and color are painted on surfaces.
#include <gtest/gtest.h>

#include <fovea/style/json.h>
#include <fovea/vector/center_lines.h>

#include "drawing.h"

using namespace fovea;
using namespace fovea::drawing;
using namespace fovea::vector;

namespace {

constexpr double wide = 20.0;  // px, of the pen

/// Linear in space, within [0.1, 0.9] on the squares below.
float ramp(const vec3& p) { return 0.5f + 0.3f * p.x + 0.1f * p.y; }
vec3 hue(const vec3& p) { return vec3(ramp(p), 0.25f, 1.0f - ramp(p)); }

template <typename Value>
auto at_corners(const meshes::Mesh& mesh, const Value& value) {
    std::vector<decltype(value(vec3()))> values;
    for (const int v : mesh.corner_verts) values.push_back(value(mesh.positions[v]));
    return values;
}

const View above = orthographic({0, 0, 5}, {0, 0, 0}, 6.0, 320, 240);
const View aslant = perspective({0.5, -4, 1.5}, {0, 0, 0}, 50.0, 320, 240);

/// Paints called "w" (numbers) and "c" (colors) on a mesh, for the line set's pen and more of the style.
struct Painting {
    std::vector<float> numbers;
    std::vector<vec3> colors;
    Job job;

    Painting(const meshes::Mesh& mesh, const View& view, const std::string& pen, const std::string& more = "",
             const std::string& away = "")
        : numbers(at_corners(mesh, ramp)), colors(at_corners(mesh, hue)) {
        job = {.scene = std::make_shared<Scene>(Scene({place(mesh)})),
               .view = view,
               .style = style::read_style(R"({"schema": 1, )" + more +
                                          R"("line_sets": [{"kinds": {"border": {}}, "least_length": 0, "pen": )" +
                                          pen + away + "}]}"),
               .assets = std::make_shared<Assets>("."),
               .backend = std::make_shared<CpuBackend>()};
        job.overrides.painted[{style::PaintSource::attribute, "w"}] = {numbers};
        job.overrides.painted_colors[{style::PaintSource::attribute, "c"}] = {colors};
    }
};

/// A pen 240 px high pictures have `wide` pixels wide, with more members.
std::string pen(const std::string& more) { return R"({"width": 20, "width_unit": "pixels", )" + more + "}"; }

const std::string width_w = R"("paint_width": "attribute", "paint_width_name": "w")";
const std::string opacity_w = R"("paint_opacity": "attribute", "paint_opacity_name": "w")";
const std::string color_c = R"("paint_color": "attribute", "paint_color_name": "c")";

/// Calls visit(point in the scene, its number).
template <typename Visit>
std::size_t each_point(const Frame& frame, const CenterLines& lines, const Visit& visit) {
    const dmat4 to_world = glm::inverse(frame.job.view.world_to_view);
    for (Index i = 0; i < lines.position_view.size(); ++i)
        visit(vec3(to_world * dvec4(dvec3(lines.position_view[i]), 1.0)), i);
    return lines.position_view.size();
}

}  // namespace

TEST(PenPaints, WidthOpacityAndColorAreWhatIsPaintedAtEachPointOfAStroke) {
    for (const View& view : {above, aslant})
        for (const int squares : {1, 9}) {
            Painting made(meshes::grid(squares), view, pen(width_w + ", " + opacity_w + ", " + color_c));
            made.job.style.line_sets[0].pen.opacity = 0.5;
            Frame frame(std::move(made.job));
            const CenterLines lines = center_lines_of(frame);
            float least = 1.0f, most = 0.0f;
            const std::size_t points = each_point(frame, lines, [&](const vec3& at, Index i) {
                const float value = ramp(at);
                EXPECT_NEAR(lines.width_px[i], wide * value, 0.01 * wide) << at.x << " " << at.y;
                EXPECT_NEAR(lines.opacity[i], 0.5 * value, 0.005);
                EXPECT_NEAR(glm::distance(lines.color[i], hue(at)), 0.0f, 0.01f);
                least = std::min(least, value);
                most = std::max(most, value);
            });
            EXPECT_GE(points, 4u);
            EXPECT_LT(least, 0.15f);
            EXPECT_GT(most, 0.85f);
        }
}

TEST(PenPaints, StrokesHaveColorsIfAPenTakesThemFromSurfacesAndThePictureHasThem) {
    Painting plain(meshes::grid(1), above, pen(width_w)), painted(meshes::grid(1), above, pen(color_c));
    Frame without(std::move(plain.job)), with(std::move(painted.job));
    without.shape();
    with.ink();
    EXPECT_TRUE(without.strokes->color.empty());
    ASSERT_EQ(with.strokes->color.size(), with.strokes->px.size());
    const dmat4 to_world = glm::inverse(above.view_to_clip * above.world_to_view);
    std::size_t seen = 0;
    for (int y = 0; y < above.height; ++y)
        for (int x = 0; x < above.width; ++x) {
            const vec4 pixel = with.passes.lines[std::size_t(y) * above.width + x];
            const vec3 at(to_world * dvec4(2 * (x + 0.5) / above.width - 1, 2 * (y + 0.5) / above.height - 1, 0, 1));
            // Beside the middle of a side, where the nearest point of the border has the color.
            const bool left = at.x < -0.9f && at.x > -1.1f && std::abs(at.y) < 0.5f;
            if (!left || pixel.a < 1.0f) continue;
            EXPECT_NEAR(glm::distance(vec3(pixel), hue({-1.0f, at.y, 0.0f})), 0.0f, 0.01f);
            ++seen;
        }
    EXPECT_GT(seen, 200u);
}

TEST(PenPaints, WhereNothingIsPaintedThePenDrawsAsItSays) {
    const meshes::Mesh mesh = meshes::grid(2);
    Painting made(mesh, above, pen(width_w + ", " + color_c + R"(, "color": [0, 1, 0])"));
    made.job.overrides.painted.begin()->second = {In<float>()};
    made.job.overrides.painted_colors.begin()->second = {In<vec3>()};
    Painting bare(mesh, above, pen(R"("color": [0, 1, 0])"));
    Painting unknown(mesh, above, pen(width_w + R"(, "color": [0, 1, 0])"));
    unknown.job.overrides = {};
    Frame frame(std::move(made.job)), same(std::move(bare.job)), lacking(std::move(unknown.job));
    for (Frame* each : {&frame, &same, &lacking}) each->ink();
    EXPECT_EQ(frame.passes.lines, same.passes.lines);
    EXPECT_EQ(lacking.passes.lines, same.passes.lines);
}

TEST(PenPaints, APenOutOfFocusTakesItsOwn) {
    const std::string half = R"("effects": {"lines": "uniform", "uniform": 0.5}, )";
    Painting made(meshes::grid(3), above, pen(width_w + ", " + color_c), half,
                  R"(, "pen_away": {"width": 8, "paint_width": "constant", "paint_color": "constant",
                      "color": [1, 1, 0]})");
    Frame frame(std::move(made.job));
    const CenterLines lines = center_lines_of(frame);
    const std::size_t points = each_point(frame, lines, [&](const vec3& at, Index i) {
        EXPECT_NEAR(lines.width_px[i], 0.5 * (wide * ramp(at) + 8.0), 0.01 * wide);
        EXPECT_NEAR(glm::distance(lines.color[i], 0.5f * (hue(at) + vec3(1, 1, 0))), 0.0f, 0.01f);
    });
    EXPECT_GE(points, 4u);
}

TEST(PenPaints, AStepStaysWithinTheEdgeWhereItIsPainted) {
    const meshes::Mesh mesh = meshes::grid(20);
    Painting made(mesh, above, pen(width_w));
    made.numbers = at_corners(mesh, [](const vec3& p) { return p.x < 0.01f ? 0.25f : 1.0f; });
    made.job.overrides.painted.begin()->second = {made.numbers};
    Frame frame(std::move(made.job));
    const CenterLines lines = center_lines_of(frame);
    std::size_t beside = 0;
    each_point(frame, lines, [&](const vec3& at, Index i) {
        if (at.x > 1e-3f && at.x < 0.099f) return;
        EXPECT_NEAR(lines.width_px[i], wide * (at.x < 0.05f ? 0.25 : 1.0), 0.01 * wide) << at.x;
        beside += std::abs(at.x) < 0.11f;
    });
    EXPECT_GE(beside, 4u) << "a point at each side of the step, on two sides of the square";
}

TEST(PenPaints, MaterialsAndObjectsHaveOneValueEach) {
    meshes::Mesh mesh = meshes::of_polygons("pair", {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {2, 0, 0}, {2, 1, 0}},
                                            {{0, 1, 2, 3}, {1, 4, 5, 2}});
    mesh.material = {0, 1};
    const Drawing drawn({place(mesh)}, above, {line_set({"border"})});
    const std::vector<float> numbers{0.25f, 0.75f};
    const Array<float> of_materials = values_on_paths(drawn.paths, drawn.scene, {numbers}, 1.0f, PaintedOn::materials);
    const Array<float> of_object = values_on_paths(drawn.paths, drawn.scene, {numbers}, 1.0f, PaintedOn::surface);
    for (Index i = 0; i < drawn.paths.points_obj.size(); ++i) {
        const float x = drawn.paths.points_obj[i].x;
        EXPECT_EQ(of_object[i], 0.25f);
        if (std::abs(x - 1.0f) > 0.1f) {
            EXPECT_EQ(of_materials[i], x < 1.0f ? 0.25f : 0.75f) << x;
        }
    }
    // A material that has no value leaves the pen's own.
    const Array<float> missing =
        values_on_paths(drawn.paths, drawn.scene, {In<float>(numbers).first(1)}, 1.0f, PaintedOn::materials);
    EXPECT_EQ(*std::ranges::max_element(missing), 1.0f);
}

TEST(PenPaints, AMeshWithoutFacesIsPaintedAtItsVertices) {
    meshes::Mesh mesh("wire", {{-1, 0, 0}, {0, 0, 0}, {1, 0, 0}});
    mesh.edge(0, 1);
    mesh.edge(1, 2);
    const Drawing drawn({place(mesh)}, above, {line_set({"border"})});
    const std::vector<float> numbers{0.0f, 0.5f, 1.0f}, few{0.0f};
    const Array<float> found = values_on_paths(drawn.paths, drawn.scene, {numbers}, 1.0f);
    ASSERT_GE(found.size(), 3u);
    for (Index i = 0; i < found.size(); ++i) EXPECT_EQ(found[i], 0.5f + 0.5f * drawn.paths.points_obj[i].x);
    EXPECT_THROW(values_on_paths(drawn.paths, drawn.scene, {few}, 1.0f), std::invalid_argument);
}

TEST(PenPaints, WhatIsNoNumberOrBeyondItsLimitsDoesNotReachStrokes) {
    const float nan = std::numeric_limits<float>::quiet_NaN(), infinite = std::numeric_limits<float>::infinity();
    EXPECT_EQ(painted_value(nan, 1.0f), 1.0f);
    EXPECT_EQ(painted_value(infinite, 1.0f), 1.0f);
    EXPECT_EQ(painted_value(-3.0f, 1.0f), 0.0f);
    EXPECT_EQ(painted_value(vec3(nan, 0, 0), vec3(0.5f)), vec3(0.5f));
    EXPECT_EQ(painted_value(vec3(-1, infinite, 2), vec3(0.5f)), vec3(0, most_light, 2));
}
