// SPDX-License-Identifier: GPL-3.0-or-later
// The list of line definitions.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include <fovea/line/definition.h>

namespace fovea {

/// All definitions; a definition's index is its bit in Kinds.
const std::vector<const LineDefinition*>& line_definitions();

/// Index of a definition; throws std::invalid_argument, listing the known names, for an unknown one.
Index definition_index(std::string_view name);

/// Bits of the definitions that lie on the smooth surface: its contours.
Kinds smooth_contours();

}  // namespace fovea
