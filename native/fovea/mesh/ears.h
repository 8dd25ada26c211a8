// SPDX-License-Identifier: GPL-3.0-or-later
// Ear clipping, for polygons that come without a triangulation (files read outside Blender).
#pragma once

#include <fovea/mesh/surface.h>

namespace fovea::mesh {

/// Triangulates a polygon: n - 2 triangles for n >= 3 corners (else none), as indices into `corners`, with the
/// polygon's winding, inside its outline as projected along its Newell normal. Self-intersecting polygons give badly
/// shaped triangles. Time n times the number of reflex corners on common polygons.
/// Meisters, "Polygons have ears", American Mathematical Monthly 82, 1975.
std::vector<Triangle> cut_ears(In<vec3> corners);

}  // namespace fovea::mesh
