// SPDX-License-Identifier: GPL-3.0-or-later
// Style files.
#pragma once

#include <string_view>

#include <fovea/style/style.h>

namespace fovea::style {

/// A style from its file's JSON. What is not given is as its default; a pen out of focus as the one in focus; fields
/// that are not known are left alone. Throws std::invalid_argument with a sentence that names the field where a value
/// has the wrong type.
Style read_style(std::string_view json);

}  // namespace fovea::style
