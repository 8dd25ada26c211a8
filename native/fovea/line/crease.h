// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <fovea/line/definition.h>

namespace fovea::line {

/// The bit of creases, of which narrow strips have one (runs/narrow_strips.h).
Kinds creases();

}  // namespace fovea::line
