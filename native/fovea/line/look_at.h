// SPDX-License-Identifier: GPL-3.0-or-later
// The view of a placement.
#pragma once

#include <fovea/line/definition.h>

namespace fovea::line {

/// The view of a placement of a tracer's scene from its eye. `surface`: the placement's, pre-stretched (as_placed).
SurfaceView look_at(const Surface& surface, Index placement, const Tracer& tracer);

/// Facets whose planes are as near to the eye, as a share of its distance, are seen edge-on: that is what planes of
/// single precision can tell. Where they do not face the viewer, a body that is seen along its sides, as in elevations,
/// has its outline where it is nearest; rounding would decide for each side alone, and hide the outline behind some of
/// them.
inline constexpr double edge_on_to_viewer = 1e-6;

/// SurfaceView::facing. `edge_on`: see edge_on_to_viewer; 0: facets face the eye whose planes have it on their front or
/// in them.
Array<std::uint8_t> facing_of(const SurfaceView& seen, double edge_on);

}  // namespace fovea::line
