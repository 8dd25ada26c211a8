// SPDX-License-Identifier: GPL-3.0-or-later
// Reading and writing of PNG files.
#pragma once

#include <string>

#include <fovea/stroke/pen.h>

namespace fovea::color {

/// Reads a PNG as gray: white is full ink. Throws std::invalid_argument, naming the file, when it cannot be read.
PenTexture read_texture(const std::string& path);

/// The bytes of a PNG file of width x height pixels, sRGB, three values each, bottom row first (as in textures). Throws
/// std::invalid_argument if the number of values does not match, or is 0.
std::string png_bytes(In<std::uint8_t> rgb, int width, int height);

}  // namespace fovea::color
