// SPDX-License-Identifier: GPL-3.0-or-later
// Edges of polygons that come without any (files read outside Blender).
#pragma once

#include <fovea/base/types.h>

namespace fovea {

/// The distinct vertex pairs along polygons, numbered by first appearance, and for every corner the edge to the next.
struct PolygonEdges {
    Array<glm::ivec2> edge_verts;
    Array<int> corner_edges;
};
PolygonEdges polygon_edges(In<int> polygon_offsets, In<int> corner_verts);

}  // namespace fovea
