// SPDX-License-Identifier: GPL-3.0-or-later
// Triangles of polygons that come without any (files read outside Blender).
#pragma once

#include <fovea/mesh/surface.h>

namespace fovea::mesh {

/// Corners, as numbers from 0, of the triangles of a polygon: n - 2 for n corners, turned as it is, inside its outline
/// as seen along its average normal; badly shaped ones where it crosses itself. Ears are cut one after the other, in
/// time n times the number of hollow corners for common polygons.
/// Meisters, "Polygons have ears", American Mathematical Monthly 82, 1975.
std::vector<Triangle> cut_ears(In<vec3> corners);

}  // namespace fovea::mesh
