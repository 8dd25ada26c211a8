// SPDX-License-Identifier: GPL-3.0-or-later
// A style between two: for changes of style over time.
#pragma once

#include <fovea/style/style.h>

namespace fovea::style {

/// The style that is `one` at a share of 0 or less and `other` at 1 or more. Numbers and colors go over steadily. Lines
/// that both draw go from the one's pen to the other's, lines of one alone fade. Words and switches change half way.
/// Where to look is said by `one`.
Style mix(const Style& one, const Style& other, double share);

}  // namespace fovea::style
