// SPDX-License-Identifier: GPL-3.0-or-later
// Which side of polygons is out.
#pragma once

#include <fovea/repair/repair.h>

namespace fovea::repair {

/// Turns polygons so that those on both sides of an edge agree, as far as the surface has two sides: closed parts face
/// outwards, open ones as most of their polygons did. Edges of more than two polygons part what they join. Returns how
/// many were turned.
Index orient(RepairedMesh& mesh);

}  // namespace fovea::repair
