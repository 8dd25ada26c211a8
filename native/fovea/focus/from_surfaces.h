// SPDX-License-Identifier: GPL-3.0-or-later
// Focus by distance from surfaces: asked for at few places, in between where it cannot change much (focus_tolerance).
#pragma once

#include <fovea/focus/focus.h>

namespace fovea::focus {

/// f of each atlas sample: pieces are halved until f cannot change by more than the tolerance over a part.
Array<float> focus_along_pieces(const ClippedPaths& clipped, const Focus& focus);

/// f of each pixel: of a lattice first, then of what lies between, where the surface seen goes on there. `distance` as
/// for focus_of_pixels.
Array<float> focus_between_pixels(const View& view, In<float> distance, const Focus& focus);

}  // namespace fovea::focus
