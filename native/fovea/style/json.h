// SPDX-License-Identifier: GPL-3.0-or-later
// Style files.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include <fovea/style/style.h>

namespace fovea::style {

inline constexpr int schema = 1;  ///< number of the format, which files name

/// Names of pen textures and papers that there are.
struct Shipped {
    std::vector<std::string> textures, papers;
};

/// A style from its file's JSON. What is not given is as its default, of a pen out of focus as in the one in focus.
/// What is not known is kept. Throws std::invalid_argument with a sentence that names the value that has a wrong type
/// or is out of its range; `shipped`, if not null, says which textures and papers may be named.
Style read_style(std::string_view json, const Shipped* shipped = nullptr);

/// The file of a style: read_style gives the same one back, and this of it the same file.
std::string write_style(const Style& style);

/// Parameters of a line definition, checked against it.
Parameters checked_parameters(const std::string& definition, const Parameters& given, const std::string& where);

}  // namespace fovea::style
