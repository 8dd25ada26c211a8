// SPDX-License-Identifier: GPL-3.0-or-later
// The lines across triangles that one definition finds, as they are drawn.
#pragma once

#include <fovea/line/definition.h>
#include <fovea/path/chain_curves.h>

namespace fovea {

/// Found, chained, smoothed, freed of hooks and of what runs along a contour (`near` of doubles.h; empty: nothing) and
/// selected.
CurveChains curves_of(const LineDefinition& definition, const SurfaceView& seen, const Values& values,
                      In<std::uint8_t> near = {});

}  // namespace fovea
