// SPDX-License-Identifier: GPL-3.0-or-later
// The lines across triangles that one definition finds, as they are drawn.
#pragma once

#include <fovea/line/definition.h>
#include <fovea/path/chain_curves.h>

namespace fovea {

/// Found, chained and smoothed. Contours are then projected to the smooth surface; features lose the hooks at their
/// ends and what runs along a contour (`near` of doubles.h; empty: nothing). Of both, the stretches that the rule
/// selects.
CurveChains curves_of(const CurveRule& rule, const SurfaceView& seen, const Values& values, In<std::uint8_t> near = {});

}  // namespace fovea
