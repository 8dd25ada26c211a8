// SPDX-License-Identifier: GPL-3.0-or-later
// Line definitions by name: what they find, and the defaults of their parameters.
#pragma once

#include <string>
#include <string_view>

#include <fovea/line/registry.h>

namespace fovea {
using namespace draw;

/// rule_of<CurveRule>("ridge").find(seen, values)
template <typename Rule>
const Rule& rule_of(std::string_view definition) {
    return std::get<Rule>(definition_called(definition).rule);
}

template <typename Rule>
bool has_rule(const LineDefinition& definition) {
    return std::holds_alternative<Rule>(definition.rule);
}

inline Values defaults(const std::string& definition) { return default_values(definition_called(definition)); }

}  // namespace fovea
