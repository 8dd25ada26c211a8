// SPDX-License-Identifier: GPL-3.0-or-later
// Reading and writing style files (JSON).
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include <fovea/style/style.h>

namespace fovea::style {

inline constexpr int schema = 1;  ///< version of the format, stored in files

/// Names of the available pen textures and papers.
struct Shipped {
    std::vector<std::string> textures, papers;
};

/// Parses a style file. Missing values take their defaults; those of an out-of-focus pen take the values of the pen in
/// focus. Unknown values are preserved (Style::kept). Files that definitions are given have paths relative to the
/// style's own folder, none of which leave it. Throws std::invalid_argument with a sentence that names the value
/// with a wrong type or out of range. `shipped`, if not null, restricts which textures and papers may be named.
Style read_style(std::string_view json, const Shipped* shipped = nullptr);

/// Serializes a style. read_style restores it exactly; writing that again gives the same text.
std::string write_style(const Style& style);

/// Validates parameters of a line definition; throws std::invalid_argument, with `where` as the place in the message.
Parameters checked_parameters(const std::string& definition, const Parameters& given, const std::string& where);

}  // namespace fovea::style
