// SPDX-License-Identifier: GPL-3.0-or-later
// Focus by distance from surfaces: evaluated at few places, interpolated where it cannot change by more than
// focus_tolerance.
#pragma once

#include <fovea/focus/focus.h>

namespace fovea::focus {

/// f of each atlas sample: pieces are bisected until f cannot change by more than the tolerance over a part.
Array<float> focus_along_pieces(const ClippedPaths& clipped, const Focus& focus);

/// f of each pixel: evaluated on a lattice, interpolated between where the visible surface is continuous. `distance` as
/// for focus_of_pixels.
Array<float> focus_between_pixels(const View& view, In<float> distance, const Focus& focus);

}  // namespace fovea::focus
