// SPDX-License-Identifier: GPL-3.0-or-later
// What a call says when it refuses what it is given.
#pragma once

#include <stdexcept>
#include <string>

#include <fovea/base/namespaces.h>

namespace fovea {
using namespace draw;

/// The sentence; empty when the call goes through.
template <typename Call>
std::string refused(const Call& call) {
    try {
        call();
    } catch (const std::invalid_argument& problem) {
        return problem.what();
    }
    return "";
}

}  // namespace fovea
