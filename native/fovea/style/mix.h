// SPDX-License-Identifier: GPL-3.0-or-later
// Interpolation of two styles, for transitions over time.
#pragma once

#include <fovea/style/style.h>

namespace fovea::style {

/// Interpolates: `one` at share <= 0, `other` at share >= 1. Numbers and colors change continuously. Lines that both
/// styles draw change from one's pen to the other's, lines of one alone fade. Strings and switches change at share .5.
/// Focus is that of `one`.
Style mix(const Style& one, const Style& other, double share);

}  // namespace fovea::style
