// SPDX-License-Identifier: GPL-3.0-or-later
#include <tool/options.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <limits>
#include <tool/statistics.h>

#include <fovea/line/registry.h>

namespace fovea::tool {
namespace {

constexpr int largest_picture = 65536;  // pixels along a side, as in Blender

std::vector<std::string> all_lines() {
    std::vector<std::string> names;
    for (const LineDefinition* definition : line_definitions()) names.push_back(definition->name);
    return names;
}

/// Numbers from `low` to `high`; CLI::Range lets pass what is no number.
CLI::Validator within(int low, int high) {
    const auto check = [low, high](const std::string& text) {
        double number = std::numeric_limits<double>::quiet_NaN();
        CLI::detail::lexical_cast(text, number);
        if (number >= low && number <= high) return std::string();
        return "'" + text + "' is not a number from " + std::to_string(low) + " to " + std::to_string(high);
    };
    return CLI::Validator(check, "");
}

/// Sizes of paper by their names.
std::map<std::string, vector::Sheet> sheets() {
    std::map<std::string, vector::Sheet> named;
    int number = 0;
    for (const style::Choice& choice : style::choices_of<vector::Sheet>) named[choice.name] = vector::Sheet(number++);
    return named;
}

void add_vectors(CLI::App& app, vector::Options& vectors) {
    app.add_option("--paper", vectors.sheet, "of vectors: page (as the style says), pixels, a0 to a5, letter")
        ->transform(CLI::CheckedTransformer(sheets(), CLI::ignore_case));
    app.add_option("--paper-margin", vectors.margin, "millimeters free around the picture on a sheet of paper")
        ->capture_default_str()
        ->check(within(0, 1000));
    app.add_option("--tolerance", vectors.tolerance, "millimeters that curves may be off")
        ->capture_default_str()
        ->check(within(0, 1000));
    app.add_flag("--plotter", vectors.plotter, "lines of one width in an order of short ways");
}

void take_size(const std::string& text, Camera& camera) {
    char rest;
    if (std::sscanf(text.c_str(), "%5dx%5d%c", &camera.width, &camera.height, &rest) != 2 || camera.width < 1 ||
        camera.height < 1 || std::max(camera.width, camera.height) > largest_picture)
        throw CLI::ValidationError(
            "--size", "'" + text + "' is not WIDTHxHEIGHT, up to " + std::to_string(largest_picture) + " pixels");
}

}  // namespace

Options parse(int count, char** words) {
    Options options;
    CLI::App app(
        "Draws a model (OBJ or PLY) without Blender and prints, as JSON, what it is made of, how many lines it has "
        "and how long each stage takes.");
    app.allow_windows_style_options(false);  // on Windows, too, /models/ball.obj is a file
    app.add_option("model", options.model, "an .obj or .ply file")->required();
    app.add_option("--lines", options.lines, "line definitions by name, with commas between them, or all")
        ->delimiter(',')
        ->excludes(app.add_option("--style", options.style, "a style file, which says itself what its lines are"));
    app.add_option("--assets", options.assets, "the folder with the textures and papers that the style names");
    app.add_option("-o,--output", options.output, "draws the model: a PNG, SVG, PDF or DXF file");
    app.add_option_function<std::string>(
        "--size", [&](const std::string& text) { take_size(text, options.camera); },
        "of the picture, WIDTHxHEIGHT (1920x1080)");
    add_vectors(app, options.vectors);
    Camera& camera = options.camera;
    app.add_option("--azimuth", camera.azimuth, "degrees left of the model's front")
        ->capture_default_str()
        ->check(within(-360, 360));
    app.add_option("--elevation", camera.elevation, "degrees above it")->capture_default_str()->check(within(-90, 90));
    app.add_option("--lens", camera.lens, "millimeters")->capture_default_str()->check(within(1, 5000));
    app.add_option("--margin", camera.margin, "percent free on each side")->capture_default_str()->check(within(0, 49));
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
