// SPDX-License-Identifier: GPL-3.0-or-later
// Consistent orientation of polygons.
#pragma once

#include <fovea/repair/repair.h>

namespace fovea::repair {

/// Flips polygons so that the two at each edge agree, as far as the surface is orientable. Closed components then face
/// outwards, open ones as the majority of their polygons did. Edges of more than two polygons separate components.
/// Returns the number of flipped polygons.
Index orient(RepairedMesh& mesh);

}  // namespace fovea::repair
