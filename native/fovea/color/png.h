// SPDX-License-Identifier: GPL-3.0-or-later
// Reading and writing of PNG files.
#pragma once

#include <filesystem>
#include <string>

#include <fovea/stroke/pen.h>

namespace fovea::color {

inline constexpr int largest_side = 4096;                  ///< pixels of a texture along a side
inline constexpr std::size_t largest_texture = 64u << 20;  ///< bytes of its file

/// Reads a PNG as gray: white is full ink. Throws std::invalid_argument, naming the file, when it cannot be read or is
/// larger than the limits, which is known before its pixels are read.
PenTexture read_texture(const std::filesystem::path& file);

/// A PNG of any kind as gray, sRGB, bottom row first; what is transparent lies on white.
struct GrayImage {
    int width = 0, height = 0;
    Array<std::uint8_t> values;
};

/// The same in colors: red, green and blue of each pixel.
struct RgbImage {
    int width = 0, height = 0;
    Array<std::uint8_t> values;
};

/// Reads all of a file's bytes. Throw std::invalid_argument if they cannot be read.
GrayImage gray_png(In<std::uint8_t> file);
RgbImage rgb_png(In<std::uint8_t> file);

/// The bytes of a PNG file of width x height pixels, sRGB, bottom row first (as in textures). Each has one value
/// (gray), three, or four with alpha, by which colors are not multiplied. Throws std::invalid_argument if the number of
/// values does not match, or is 0.
std::string png_bytes(In<std::uint8_t> values, int width, int height, int channels = 3);

}  // namespace fovea::color
