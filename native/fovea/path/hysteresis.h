// SPDX-License-Identifier: GPL-3.0-or-later
// Hysteresis along chains: which stretches of them are lines.
#pragma once

#include <fovea/path/chain_curves.h>

namespace fovea::path {

/// The stretches of chains that a selection keeps, in their order. Cut chains are open; a closed one that is cut
/// nowhere stays closed.
CurveChains select_stretches(const CurveChains& chains, const Selection& selection);

/// Open chains without the spurs at their ends: noise where a line fades. A spur turns by more than 60 degrees within
/// two side lengths of the end.
CurveChains without_spurs(const CurveChains& chains, const Surface& surface);

/// What is left of chains where `removed` (per triangle of the surface) is not set.
CurveChains without_triangles(const CurveChains& chains, In<std::uint8_t> removed);

}  // namespace fovea::path
