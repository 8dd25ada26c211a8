// SPDX-License-Identifier: GPL-3.0-or-later
// How many threads parallel loops use.
#pragma once

#include <fovea/base/namespaces.h>

namespace fovea::base {

/// Most threads that work at once from now on, all of the process' together, Embree's too; 0: as many as the machine
/// has. Results never depend on it. Throws std::invalid_argument for a negative number. Not to be called from two
/// threads at once.
void limit_threads(int most);

/// The limit that holds.
int thread_limit();

}  // namespace fovea::base
