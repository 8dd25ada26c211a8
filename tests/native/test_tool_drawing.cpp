// SPDX-License-Identifier: GPL-3.0-or-later
// What the tool draws.
#include <filesystem>
#include <fstream>
#include <gtest/gtest.h>
#include <tool/drawing.h>
#include <tool/read_obj.h>

#include <fovea/base/files.h>
#include <fovea/color/png.h>

#include "learned.h"
#include "model_files.h"
#include "refused.h"
#include "system_files.h"

using namespace fovea;
using namespace fovea::draw;
using namespace fovea::model_files;

namespace {

struct Folder {
    std::filesystem::path path = own_path("drawing");
    Folder() { std::filesystem::create_directories(path); }
    ~Folder() { std::filesystem::remove_all(path); }
    int count() const { return int(std::distance(std::filesystem::directory_iterator(path), {})); }
};

}  // namespace

TEST(ToolDrawing, OfACubeIsInkOnWhitePaperInAFileOfThePicturesSize) {
    const Folder folder;
    Frame frame = tool::frame_of(tool::read_obj("cube.obj", cube_obj()), {.width = 200, .height = 120},
                                 tool::style_of({"contour", "crease"}));
    frame.picture();
    tool::write_png(frame, folder.path / "cube.png");
    const PenTexture seen = read_texture(folder.path / "cube.png");
    EXPECT_EQ(seen.width, 200);
    EXPECT_EQ(seen.height, 120);
    std::size_t white = 0, darker = 0;  // strokes are a fifth of a pixel wide at this size
    for (const float value : seen.ink) {
        white += value == 1.0f;
        darker += value < 0.97f;
    }
    EXPECT_GT(white, seen.ink.size() * 8 / 10);
    EXPECT_GT(darker, 200u);
    EXPECT_EQ(folder.count(), 1);
}

TEST(ToolDrawing, WhatCannotBeWrittenOrReadIsNamed) {
    const Folder folder;
    Frame frame = tool::frame_of(tool::read_obj("cube.obj", cube_obj()), {.width = 32, .height = 32},
                                 tool::style_of({"contour"}));
    frame.picture();
    const auto nowhere = folder.path / "missing" / "cube.png";
    EXPECT_NE(refused([&] { tool::write_png(frame, nowhere); }).find("missing"), std::string::npos);
    EXPECT_EQ(refused([&] { tool::write_png(frame, folder.path); }),
              name_of(folder.path) + " could not be written: Is a directory");
    EXPECT_NE(refused([&] { tool::read_style(folder.path / "none.json"); }).find("none.json"), std::string::npos);
    std::ofstream(folder.path / "broken.json") << R"({"schema": 1, "paper": {"tooth": "sharp"}, "line_sets": [{}]})";
    EXPECT_NE(refused([&] { tool::read_style(folder.path / "broken.json"); }).find("paper.tooth"), std::string::npos);
}

TEST(ToolDrawing, LinesByAModelAreThoseOfTheFileThatTheStyleNames) {
    const Folder folder;
    const auto style = folder.path / "style.json", model = folder.path / "model.json";
    std::ofstream(style) << R"({"schema": 1, "line_sets": [{"kinds": {"learned_line": {"model": "model.json"}}}]})";
    const auto drawn = [&] {
        Frame frame = tool::frame_of(tool::read_obj("cube.obj", cube_obj()), {.width = 200, .height = 120},
                                     tool::read_style(style));
        frame.find();
        return frame.paths->count();
    };
    EXPECT_EQ(refused(drawn), name_of(model) + " cannot be read: No such file or directory");
    std::ofstream(model) << study::write_model(lines_below(study::Property::image_least_curvature, -0.05));
    EXPECT_GT(drawn(), 0u);
    std::ofstream(model) << "{}";
    EXPECT_TRUE(refused(drawn).starts_with(name_of(model) + ": a model of lines: 'line_model' is missing"));
    std::filesystem::create_directories(folder.path / "styles");
    std::filesystem::rename(style, folder.path / "styles" / "style.json");
    if (!make_link(model, folder.path / "styles" / "model.json")) GTEST_SKIP() << "links cannot be made here";
    EXPECT_NE(refused([&] { tool::read_style(folder.path / "styles" / "style.json"); }).find("leads out"),
              std::string::npos);
}

TEST(ToolDrawing, AFullDiskIsNamedAndLeavesTheFileThatWasThere) {
    const Folder folder;
    const auto file = folder.path / "cube.png";
    std::ofstream(file) << "old";
    Frame frame = tool::frame_of(tool::read_obj("cube.obj", cube_obj()), {.width = 320, .height = 200},
                                 tool::style_of({"contour"}));
    frame.picture();
    std::string said;
    {
        const FileLimit limit(200);
        if (!limit.holds()) GTEST_SKIP() << "this system does not limit the size of files";
        said = refused([&] { tool::write_png(frame, file); });
    }
    EXPECT_EQ(said, name_of(file) + " could not be written: File too large");
    EXPECT_EQ(std::filesystem::file_size(file), 3u);
    EXPECT_EQ(folder.count(), 1);
}

TEST(ToolDrawing, FramesWhatIsDrawnAndNothingElseOfTheFile) {
    const auto seen = [](const std::string& more) {
        const Frame frame =
            tool::frame_of(tool::read_obj("cube.obj", cube_obj() + more), {.width = 32, .height = 32}, {});
        return frame.job.view.world_to_view;
    };
    const glm::dmat4 cube = seen("");
    EXPECT_EQ(seen("v 1e30 0 0\n"), cube) << "no polygon has it";
    EXPECT_EQ(seen("v 50 -50 50\n"), cube);
    EXPECT_EQ(seen("v nan 0 0\nv 90 90 90\nf 1 9 10\n"), cube) << "a polygon with a broken vertex";
    EXPECT_NE(seen("v 50 -50 50\nf 1 2 9\n"), cube);
}
