// SPDX-License-Identifier: GPL-3.0-or-later
// Memory that is given back.
#pragma once

#include <fovea/base/namespaces.h>

namespace fovea::base {

/// Returns the freed memory that is kept for large arrays (base/large_memory.h) to the system or the heap. Thread-safe.
void release_large_memory() noexcept;

}  // namespace fovea::base
