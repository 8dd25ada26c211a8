// SPDX-License-Identifier: GPL-3.0-or-later
// The registry of line definitions.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <fovea/line/definition.h>

namespace fovea::line {

/// All definitions; a definition's index is its bit in Kinds. Do not call during static initialization: the constants
/// in other files may not be initialized yet.
const std::vector<const LineDefinition*>& line_definitions();

/// Index of the definition with a name; throws std::invalid_argument, listing the known names, for an unknown one.
Index definition_index(std::string_view name);
const LineDefinition& definition_called(std::string_view name);

/// Parameter values of a definition, in its order, from (name, value) pairs; others have their defaults. Its file is
/// that of `files`, or none. Throws std::invalid_argument for an unknown name.
Values values_of(const LineDefinition& definition, std::span<const std::pair<std::string, ParameterValue>> given,
                 const Files& files = {});

/// The bit of a definition.
Kinds kind_of(const LineDefinition& definition);

/// Bits of the definitions that find contours of the smooth surface, whole or in part.
Kinds smooth_contours();

/// Bits of those, and of the mesh-edge definition that finds all contours of the mesh.
Kinds contours();

/// Bits of definitions that lie on what the section plane cuts.
Kinds kinds_in_section();
/// Of the definitions all of whose lines have one shade.
Kinds kinds_of_one_shade();

}  // namespace fovea::line
