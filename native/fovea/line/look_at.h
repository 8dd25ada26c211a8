// SPDX-License-Identifier: GPL-3.0-or-later
// The view of a placement.
#pragma once

#include <fovea/line/definition.h>

namespace fovea::line {

/// The view of a placement of a tracer's scene from its eye. `surface`: the placement's, pre-stretched (as_placed).
SurfaceView look_at(const Surface& surface, Index placement, const Tracer& tracer);

/// SurfaceView::facing.
Array<std::uint8_t> facing_of(const SurfaceView& seen);

}  // namespace fovea::line
