// SPDX-License-Identifier: GPL-3.0-or-later
// The list of line definitions.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <fovea/line/definition.h>

namespace fovea::line {

/// All definitions; a definition's index is its bit in Kinds. Not for constants of other files, which may be made
/// before.
const std::vector<const LineDefinition*>& line_definitions();

/// Index of a definition; throws std::invalid_argument, listing the known names, for an unknown one.
Index definition_index(std::string_view name);
const LineDefinition& definition_called(std::string_view name);

/// Parameters of a definition by their names, in its order and with defaults filled in. Throws std::invalid_argument
/// for an unknown name.
Values values_of(const LineDefinition& definition, std::span<const std::pair<std::string, double>> given);

/// The bit of a definition.
Kinds kind_of(const LineDefinition& definition);

/// Bits of the definitions of contours of the smooth surface.
Kinds smooth_contours();

/// Bits of those, and of what finds all contours of the mesh.
Kinds contours();

}  // namespace fovea::line
