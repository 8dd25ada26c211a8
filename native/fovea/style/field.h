// SPDX-License-Identifier: GPL-3.0-or-later
// Structures that name their members once: what reads and writes them follows from the list.
#pragma once

#include <tuple>

namespace fovea::style {

/// A member of a structure S by its name in files. S::fields is a tuple of all of them, in the order in which they are
/// written.
template <typename S, typename V>
struct Field {
    const char* name;
    V S::* member;
};
template <typename S, typename V>
Field(const char*, V S::*) -> Field<S, V>;

template <typename S>
concept Record = requires { S::fields; };

/// visit(field) for each.
template <Record S, typename Visit>
void for_each_field(const Visit& visit) {
    std::apply([&](const auto&... field) { (visit(field), ...); }, S::fields);
}

/// The values of an enumeration by their names in files, in order: specialized where the enumeration is.
template <typename Enum>
inline constexpr const char* const* names_of = nullptr;

}  // namespace fovea::style
