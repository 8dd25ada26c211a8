// SPDX-License-Identifier: GPL-3.0-or-later
// Line definitions by name: what they find, and the defaults of their parameters.
#pragma once

#include <string>
#include <string_view>

#include <fovea/line/registry.h>

#include "learned.h"

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

/// The defaults; where the image is smoothed, by more: the time that such a definition takes goes with the number of
/// its samples, which are as far apart as it smooths. Those that need a file get a model of a rule.
inline Values quick_values(const LineDefinition& definition) {
    Values values = default_values(definition);
    for (std::size_t p = 0; p < values.size() && has_rule<ImageRule>(definition); ++p)
        if (definition.parameters[p].name == std::string_view("sigma")) values[p] = 8.0;
    if (definition.file) values.file = study::likelihood_of(lines_below(study::Property::facing, 0.4));
    return values;
}

}  // namespace fovea
