// SPDX-License-Identifier: GPL-3.0-or-later
// Polygons that all have the same number of corners.
#pragma once

#include <fovea/base/types.h>

namespace fovea::mesh {

/// Whether the polygons of a mesh all have `corners` corners (3 or 4), as their edges tell: so their offsets need not
/// be read. True if the edge of each corner joins its vertex to that of the next corner, where every `corners` corners
/// are a polygon. That can hold for no other polygons unless one has a vertex twice: a longer one would have its first
/// vertex again where it is cut, and one of three corners among quadrilaterals an edge with the same vertex at both
/// ends. edge_verts (E); corner_verts and corner_edges (C), as Blender has them. False for indices out of range.
bool all_polygons_have(int corners, In<glm::ivec2> edge_verts, In<int> corner_verts, In<int> corner_edges);

}  // namespace fovea::mesh
