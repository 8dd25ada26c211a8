// SPDX-License-Identifier: GPL-3.0-or-later
// A model's picture.
#pragma once

#include <filesystem>
#include <tool/camera.h>
#include <tool/model.h>

#include <fovea/draw/frame.h>

namespace fovea::tool {

/// A style of one line set with these definitions, all with their defaults. Throws std::invalid_argument for a
/// definition that does not exist.
style::Style style_of(const std::vector<std::string>& lines);

/// The style in a file. Throws std::invalid_argument, naming the file, where it is none.
style::Style read_style(const std::filesystem::path& file);

/// The model alone, drawn natively; no step is taken yet. `assets`: a folder with textures and papers, which only
/// styles that use them need.
Frame frame_of(const Model& model, const Camera& camera, const style::Style& style,
               const std::filesystem::path& assets = {});

/// Writes what a frame's picture shows, over white where it has no paper: a PNG of 8-bit sRGB. The file is whole or not
/// there. Throws std::invalid_argument, naming it, where it cannot be written.
void write_png(const Frame& frame, const std::filesystem::path& file);

}  // namespace fovea::tool
