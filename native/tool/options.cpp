// SPDX-License-Identifier: GPL-3.0-or-later
#include <tool/options.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <tool/statistics.h>

#include <fovea/line/registry.h>

namespace fovea::tool {
namespace {

std::vector<std::string> all_lines() {
    std::vector<std::string> names;
    for (const LineDefinition* definition : line_definitions()) names.push_back(definition->name);
    return names;
}

void take_size(const std::string& text, Camera& camera) {
    char rest;
    if (std::sscanf(text.c_str(), "%5dx%5d%c", &camera.width, &camera.height, &rest) != 2 || camera.width < 1 ||
        camera.height < 1)
        throw CLI::ValidationError("--size", "'" + text + "' is not WIDTHxHEIGHT in pixels");
}

}  // namespace

Options parse(int count, char** words) {
    Options options;
    CLI::App app(
        "Draws a model (OBJ or PLY) without Blender and prints, as JSON, what it is made of, how many lines it has "
        "and how long each stage takes.");
    app.add_option("model", options.model, "an .obj or .ply file")->required();
    app.add_option("--lines", options.lines, "line definitions by name, with commas between them, or all")
        ->delimiter(',')
        ->excludes(app.add_option("--style", options.style, "a style file, which says itself what its lines are"));
    app.add_option("--assets", options.assets, "the folder with the textures and papers that the style names");
    app.add_option("-o,--output", options.output, "draws the model: a PNG file");
    app.add_option_function<std::string>(
        "--size", [&](const std::string& text) { take_size(text, options.camera); },
        "of the picture, WIDTHxHEIGHT (1920x1080)");
    Camera& camera = options.camera;
    app.add_option("--azimuth", camera.azimuth, "degrees left of the model's front")->capture_default_str();
    app.add_option("--elevation", camera.elevation, "degrees above it")
        ->capture_default_str()
        ->check(CLI::Range(-90.0, 90.0));
    app.add_option("--lens", camera.lens, "millimeters")->capture_default_str()->check(CLI::Range(1.0, 5000.0));
    app.add_option("--margin", camera.margin, "percent free on each side")
        ->capture_default_str()
        ->check(CLI::Range(0.0, 49.0));
    app.add_option("--threads", options.threads, "at most; 0: as many as there are")->check(CLI::Range(0, 4096));
    try {
        app.parse(count, words);
    } catch (const CLI::ParseError& problem) {
        std::exit(app.exit(problem));
    }
    if (options.lines.empty()) options.lines = default_lines();
    if (std::find(options.lines.begin(), options.lines.end(), "all") != options.lines.end())
        options.lines = all_lines();
    return options;
}

}  // namespace fovea::tool
