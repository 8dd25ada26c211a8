// SPDX-License-Identifier: GPL-3.0-or-later
// Input validation: bad input throws std::invalid_argument (ValueError in Python) with a one-sentence message.
#pragma once

#include <stdexcept>
#include <string>
#include <string_view>

#include <fovea/base/namespaces.h>

namespace fovea::base {

/// Throws std::invalid_argument with `message` (name the object, say what is wrong and what to do) unless `condition`.
inline void check(bool condition, std::string_view message) {
    if (!condition) throw std::invalid_argument(std::string(message));
}

}  // namespace fovea::base
