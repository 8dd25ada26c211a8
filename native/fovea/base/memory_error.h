// SPDX-License-Identifier: GPL-3.0-or-later
// Errors of which the cause is that memory is too small, whoever reports them.
#pragma once

#include <exception>
#include <new>
#include <string_view>

namespace fovea::base {

/// Whether an error is of memory: the allocator's, or Embree's (error 4; it needs nothing but memory to start).
inline bool is_of_memory(const std::exception& error) {
    const std::string_view said = error.what();
    return dynamic_cast<const std::bad_alloc*>(&error) || said.ends_with("Embree error 4") ||
           said.starts_with("Embree could not be started");
}

}  // namespace fovea::base
