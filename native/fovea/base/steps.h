// SPDX-License-Identifier: GPL-3.0-or-later
// How many steps a way is divided into.
#pragma once

#include <algorithm>
#include <cmath>

namespace fovea::base {

/// The number of equal steps of a way that is `wanted` steps long: its ceiling, from 1 to `most`; 1 of NaN. Bounded
/// before it is converted, because what an int cannot hold is converted to another number on another machine.
inline int steps_of(double wanted, int most) { return int(std::min(std::max(1.0, std::ceil(wanted)), double(most))); }

}  // namespace fovea::base
