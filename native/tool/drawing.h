// SPDX-License-Identifier: GPL-3.0-or-later
// Drawing of a model.
#pragma once

#include <filesystem>
#include <tool/camera.h>
#include <tool/model.h>

#include <fovea/vector/compose.h>
#include <fovea/vector/file.h>

namespace fovea::tool {

/// A style of one line set with these definitions at their defaults. Throws std::invalid_argument for an unknown
/// definition.
style::Style style_of(const std::vector<std::string>& lines);

/// Reads a style file; files that its line definitions are given have absolute paths then. Throws
/// std::invalid_argument, naming the file, if it is not valid.
style::Style read_style(const std::filesystem::path& file);

/// A frame of the model alone, on the CPU backend; no step has run yet. `assets`: folder of textures and papers,
/// required only by styles that use them. Throws std::invalid_argument, naming it, for a file that a line definition of
/// the style is given and that cannot be read.
Frame frame_of(const Model& model, const Camera& camera, const style::Style& style,
               const std::filesystem::path& assets = {});

/// Writes a frame's combined pass, over white where there is no paper, as an 8-bit sRGB PNG. The file is written
/// completely or not at all. Throws std::invalid_argument, naming it, if it cannot be written.
void write_png(const Frame& frame, const std::filesystem::path& file);

/// The kind of vectors that a file's name says it has.
std::optional<vector::Kind> vectors_of(const std::filesystem::path& file);

/// Writes a frame's strokes as vectors, as write_png does pixels. What is in the file.
vector::Drawing write_vectors(Frame& frame, const vector::Options& options, vector::Kind kind,
                              const std::filesystem::path& file);

}  // namespace fovea::tool
