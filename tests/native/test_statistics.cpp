// SPDX-License-Identifier: GPL-3.0-or-later
// What the tool tells of a cube, and where its camera stands.
#include <glm/gtc/matrix_access.hpp>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <tool/read_obj.h>
#include <tool/statistics.h>

#include <fovea/line/registry.h>

#include "drawing.h"
#include "model_files.h"
#include "refused.h"

using namespace fovea;
using namespace fovea::draw;
using namespace fovea::model_files;

namespace {

tool::Model cube() { return tool::read_obj("cube.obj", cube_obj()); }

nlohmann::ordered_json statistics(const tool::Model& model, const std::vector<std::string>& lines) {
    Frame frame = tool::frame_of(model, {}, tool::style_of(lines));
    frame.see();
    return tool::statistics(model, frame);
}

}  // namespace

TEST(Statistics, OfACubeInAGeneralViewItHasTwelveCreasesAndAContourOfSixEdges) {
    const auto found = statistics(cube(), {"contour", "crease", "border"});
    EXPECT_EQ(found["model"], "cube");
    EXPECT_EQ(found["surface"]["vertices"], 8);
    EXPECT_EQ(found["surface"]["polygons"], 6);
    EXPECT_EQ(found["surface"]["triangles"], 12);
    EXPECT_EQ(found["surface"]["edges"], 12);
    EXPECT_EQ(found["surface"]["degenerate_polygons"], 0);
    EXPECT_EQ(found["lines"]["contour"]["segments"], 6);
    EXPECT_EQ(found["lines"]["crease"]["segments"], 12);
    EXPECT_EQ(found["lines"]["border"]["paths"], 0);
    EXPECT_LT(found["view"]["visible_px"], found["view"]["px"]);
    EXPECT_EQ(found["broken"]["polygons"], nlohmann::ordered_json({{"count", 0}}));
    for (const char* stage : {"bvh", "lines", "project", "visibility"})
        EXPECT_GE(found["milliseconds"][stage], 0.0) << stage;
}

TEST(Statistics, EveryDefinitionCanBeAskedForAndAnUnknownOneIsRefused) {
    std::vector<std::string> names;
    for (const LineDefinition* definition : line_definitions()) names.push_back(definition->name);
    EXPECT_EQ(statistics(cube(), names)["lines"].size(), names.size());
    EXPECT_NE(refused([] { statistics(cube(), {"moustache"}); }).find("moustache"), std::string::npos);
}

TEST(Statistics, BrokenElementsAreCountedWithTheFirstOfThem) {
    const auto found = statistics(tool::read_obj("a.obj", cube_obj() + "f 1 2 99\nf 1\n"), {"contour"});
    EXPECT_EQ(found["broken"]["polygons"]["count"], 2);
    EXPECT_EQ(found["surface"]["polygons"], 6);
}

TEST(Statistics, AModelWithoutPolygonsOrSizeHasNoLines) {
    for (const char* text : {"v 1 2 3\n", "v nan 0 0\nf 1 1 1\n", "v 5 5 5\nf 1 1 1\n"})
        EXPECT_EQ(statistics(tool::read_obj("a.obj", text), {"contour"})["view"]["visible_runs"], 0) << text;
}

TEST(CameraBeforeAModel, ShowsAllOfItAndTouchesTheMarginOnTwoSides) {
    const tool::Model model = cube();
    for (const bool y_up : {false, true})
        for (const auto& camera :
             {tool::Camera{}, {-80.0, -40.0, 20.0, 0.0, 300, 700}, {190.0, 90.0, 200.0, 20.0, 64, 64}}) {
            const View view = tool::view_of(model.positions, camera, y_up);
            dvec2 low(1e9), high(-1e9);
            for (const vec3& p : model.positions) {
                const dvec2 px = drawing::pixel_of(view, dvec3(p));
                low = glm::min(low, px);
                high = glm::max(high, px);
                const double depth = -(view.world_to_view * dvec4(p, 1.0)).z;
                EXPECT_GT(depth, view.near_clip);
                EXPECT_LT(depth, view.far_clip);
            }
            const dvec2 size(camera.width, camera.height), free = size * camera.margin / 100.0;
            const dvec2 left = low - free, right = size - free - high;
            EXPECT_GE(std::min({left.x, left.y, right.x, right.y}), -1e-6);
            EXPECT_NEAR(std::min(left.x + right.x, left.y + right.y), 0.0, 1e-6);
        }
}

TEST(CameraBeforeAModel, StandsBeforeItsFrontWithTheFormatsAxisUp) {
    const tool::Camera front{.azimuth = 0.0, .elevation = 0.0};
    const std::vector<vec3> points{{-1, -1, -1}, {1, 1, 1}};
    const auto towards = [&](bool y_up) {
        return dvec3(glm::row(tool::view_of(points, front, y_up).world_to_view, 2));
    };
    const auto up = [&](bool y_up) { return dvec3(glm::row(tool::view_of(points, front, y_up).world_to_view, 1)); };
    EXPECT_LT(glm::distance(towards(false), dvec3(0, -1, 0)), 1e-9);
    EXPECT_LT(glm::distance(towards(true), dvec3(0, 0, 1)), 1e-9);
    EXPECT_LT(glm::distance(up(false), dvec3(0, 0, 1)), 1e-9);
    EXPECT_LT(glm::distance(up(true), dvec3(0, 1, 0)), 1e-9);
    const auto left = tool::view_of(points, {.azimuth = 90.0, .elevation = 0.0}, false);
    EXPECT_LT(glm::distance(dvec3(glm::row(left.world_to_view, 2)), dvec3(-1, 0, 0)), 1e-9);
}
