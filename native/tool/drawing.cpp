// SPDX-License-Identifier: GPL-3.0-or-later
#include <tool/drawing.h>

#include <cerrno>
#include <cstdio>
#include <tool/system.h>

#include <fovea/base/check.h>
#include <fovea/base/files.h>
#include <fovea/color/png.h>
#include <fovea/color/srgb.h>
#include <fovea/study/model_likelihood.h>
#include <fovea/style/json.h>
#include <fovea/style/json_value.h>

namespace fovea::tool {
namespace {

/// Writes a file, whole or not at all; throws std::invalid_argument, with the file and the cause.
void write_whole(const std::string& bytes, const std::filesystem::path& file) {
    std::error_code cause;
    const auto hold = [&](bool holds) { check(holds, name_of(file) + " could not be written: " + cause_of(cause)); };
    if (std::filesystem::is_directory(file, cause)) cause = std::make_error_code(std::errc::is_a_directory);
    hold(cause != std::errc::is_a_directory);
    std::filesystem::path part = file;
    part += "." + std::to_string(process_number()) + ".part";
    std::FILE* stream = opened(part);
    bool written = stream && std::fwrite(bytes.data(), 1, bytes.size(), stream) == bytes.size() && on_disk(stream);
    cause = std::error_code(errno, std::generic_category());
    if (stream) written = std::fclose(stream) == 0 && written;
    if (written) std::filesystem::rename(part, file, cause);
    if (written && !cause) return;
    std::error_code ignored;
    std::filesystem::remove(part, ignored);
    hold(false);
}

/// Calls visit(path) for the files that line definitions of a style are given.
template <typename Visit>
void each_file(style::Style& style, const Visit& visit) {
    for (style::LineSet& set : style.line_sets)
        for (auto& [name, parameters] : set.kinds)
            for (auto& [parameter, value] : parameters)
                if (!value.file.empty()) visit(value.file);
}

/// The path of a file that a style in a folder names. Throws std::invalid_argument if a link leads out of the folder.
std::string inside(const std::filesystem::path& folder, const std::string& named) {
    const std::filesystem::path path = folder / file_of(named);
    std::error_code problem;  // told where the file is read
    const auto whole = std::filesystem::weakly_canonical(path, problem);
    const auto within = whole.lexically_relative(std::filesystem::weakly_canonical(folder, problem));
    check(problem || (!within.empty() && *within.begin() != ".."),
          named + ", which the style names, leads out of its folder: put the file itself there");
    return name_of(path);
}

}  // namespace

style::Style style_of(const std::vector<std::string>& lines) {
    style::Style style;
    style.line_sets[0].least_length = 0.0;
    for (const std::string& name : lines) {
        definition_index(name);
        style.line_sets[0].kinds.emplace_back(name, style::Parameters());
    }
    return style;
}

style::Style read_style(const std::filesystem::path& file) {
    style::Style style = style::read_file(file, [](const std::string& text) { return style::read_style(text); });
    const std::filesystem::path folder = std::filesystem::absolute(file).parent_path();
    each_file(style, [&](std::string& path) { path = inside(folder, path); });
    return style;
}

Frame frame_of(const Model& model, const Camera& camera, const style::Style& style,
               const std::filesystem::path& assets) {
    Job job;
    job.scene = std::make_shared<Scene>(std::vector<Placement>{{.surface = model.surface(), .id = 1}});
    job.view = view_of(model.drawn_positions(), camera, model.y_up);
    job.style = style;
    each_file(job.style, [&](const std::string& path) {
        job.files[path] = style::read_file(
            file_of(path), [](const std::string& text) { return study::likelihood_of(study::read_model(text)); });
    });
    job.assets = std::make_shared<Assets>(assets);
    job.backend = std::make_shared<CpuBackend>();
    return Frame(std::move(job));
}

void write_png(const Frame& frame, const std::filesystem::path& file) {
    const View& view = frame.job.view;
    Array<std::uint8_t> rgb(3 * frame.passes.combined.size());
    parallel_for(frame.passes.combined.size(), [&](std::size_t i) {
        const vec4& pixel = frame.passes.combined[i];
        for (int c = 0; c < 3; ++c) rgb[3 * i + c] = srgb_byte(pixel[c] + 1.0f - pixel.a);
    });
    write_whole(png_bytes(rgb, view.width, view.height), file);
}

std::optional<vector::Kind> vectors_of(const std::filesystem::path& file) {
    std::string suffix = name_of(file.extension());
    for (char& c : suffix) c = char(std::tolower(static_cast<unsigned char>(c)));
    return suffix.empty() ? std::nullopt : vector::kind_of(suffix.substr(1));
}

vector::Drawing write_vectors(Frame& frame, const vector::Options& options, vector::Kind kind,
                              const std::filesystem::path& file) {
    vector::Drawing drawing = vector::compose(frame, vector::fitting(kind, options));
    write_whole(vector::bytes_of(drawing.document, kind), file);
    return drawing;
}

}  // namespace fovea::tool
