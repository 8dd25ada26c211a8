// SPDX-License-Identifier: GPL-3.0-or-later
// The lines across triangles that one definition finds, as they are drawn.
#pragma once

#include <fovea/line/definition.h>
#include <fovea/path/chain_curves.h>

namespace fovea {

/// Traces, chains and smooths the curves of one definition. Contours are then projected to the smooth surface; features
/// lose the spurs at their ends and the stretches that duplicate a contour (`near` of doubles.h; empty: none). Of both,
/// the stretches that the rule selects by hysteresis.
CurveChains curves_of(const CurveRule& rule, const SurfaceView& seen, const Values& values, In<std::uint8_t> near = {});

}  // namespace fovea
