// SPDX-License-Identifier: GPL-3.0-or-later
// Styles and their files, from the declarations of their members: sound ones, and texts that are nearly one.
#pragma once

#include <string>

#include <fovea/style/style.h>

#include "choices.h"

namespace fovea::fuzz {

// Names of a few of the shipped files.
inline constexpr const char* textures[] = {"solid", "ink", "dashes", "pencil"};
inline constexpr const char* papers[] = {"none", "none", "none", "laid"};

/// Some members differ from their defaults, mostly within their ranges. Lines are of a few definitions.
style::Style random_style(Choices& choices);

/// The JSON of a style with up to a few values, keys or characters changed.
std::string mutated(Choices& choices, const std::string& json);

}  // namespace fovea::fuzz
