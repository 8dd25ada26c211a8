// SPDX-License-Identifier: GPL-3.0-or-later
// Numbers and names as text in files: the same on every machine and in every locale.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace fovea::vector {

inline constexpr int decimals = 3;  ///< of lengths: micrometers, or thousandths of a pixel
inline constexpr double grid = 1000.0;

/// A length as a whole number of thousandths.
std::int64_t thousandths(double value);
/// Thousandths as a decimal number, without zeros at its end.
std::string decimal(std::int64_t thousandths);
/// The number, rounded to thousandths.
std::string number(double value);

/// 16 digits.
std::string hexadecimal(std::uint64_t value);
/// "#rrggbb" of a color as displayed, each in [0,1].
std::string hex_color(double red, double green, double blue);

/// The characters of UTF-8; control characters, and bytes that are not UTF-8, as question marks.
std::u32string code_points(std::string_view text);
/// The same as UTF-8.
std::string printable(std::string_view text);

/// Text of XML and of its attributes: printable, and its own characters as entities.
std::string xml(std::string_view text);

/// Text of one line in DXF files: characters beyond ASCII, and those that would mean something else, by their numbers.
/// There are none from 65536 on: a question mark.
std::string dxf_text(std::string_view text);

/// Base64 (RFC 4648), on one line.
std::string base64(std::string_view bytes);

}  // namespace fovea::vector
