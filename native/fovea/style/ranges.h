// SPDX-License-Identifier: GPL-3.0-or-later
// Checks that the numbers of a record are in their declared ranges.
#pragma once

#include <locale>
#include <sstream>
#include <stdexcept>
#include <string>
#include <type_traits>

#include <fovea/style/field.h>

namespace fovea::style {

/// Throws std::invalid_argument for the first number of a record that is out of its range, or is none: a sentence that
/// begins with `where` and the number's name.
template <Record S>
void check_ranges(const S& record, const std::string& where) {
    for_each_field<S>([&]<typename V>(const Field<S, V>& field) {
        if constexpr (std::is_same_v<V, double> || std::is_same_v<V, int>) {
            const double value = record.*field.member, least = field.domain.least, most = field.domain.most;
            if (value >= least && value <= most) return;
            std::ostringstream sentence;
            sentence.imbue(std::locale::classic());
            sentence << where << field.name << " is " << value << ", outside " << least << " to " << most;
            if (field.domain.unit == Unit::millimeters) sentence << " mm";
            throw std::invalid_argument(sentence.str());
        }
    });
}

}  // namespace fovea::style
