// SPDX-License-Identifier: GPL-3.0-or-later
// Selection of intervals of chains by hysteresis.
#pragma once

#include <fovea/path/chain_curves.h>

namespace fovea::path {

/// The intervals of chains that a selection keeps, in order. Chains that are cut become open; closed chains without a
/// cut stay closed.
CurveChains select_stretches(const CurveChains& chains, const Selection& selection);

/// Removes spurs, which are noise where a line fades, from the ends of open chains. A spur turns by more than 60
/// degrees within two side lengths of the end.
CurveChains without_spurs(const CurveChains& chains, const Surface& surface);

/// The parts of chains outside triangles with `removed` set (per triangle of the surface). `another_goes_on`: another
/// line takes over there, so the cut ends are not free.
CurveChains without_triangles(const CurveChains& chains, In<std::uint8_t> removed, bool another_goes_on = false);

}  // namespace fovea::path
