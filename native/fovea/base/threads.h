// SPDX-License-Identifier: GPL-3.0-or-later
// Number of threads of parallel loops.
#pragma once

#include <fovea/base/namespaces.h>

namespace fovea::base {

/// Limits the threads that work at the same time in the whole process, Embree's included; 0: no limit but the
/// machine's. Results never depend on it. Throws std::invalid_argument for a negative number. Not safe to call from two
/// threads at once.
void limit_threads(int most);

/// The limit in force.
int thread_limit();

/// Number of threads that the caller's loops may use: as many as the limit and its arena allow.
int threads_at_hand();

}  // namespace fovea::base
