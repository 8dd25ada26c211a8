// SPDX-License-Identifier: GPL-3.0-or-later
// Parameters of a definition by name.
#pragma once

#include <map>
#include <string>

#include <fovea/line/definition.h>

namespace fovea::bindings {

/// In the order of the definition, with defaults filled in. Throws std::invalid_argument for an unknown name.
Values values_of(const LineDefinition& definition, std::map<std::string, double> given);

}  // namespace fovea::bindings
