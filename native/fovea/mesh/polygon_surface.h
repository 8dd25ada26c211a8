// SPDX-License-Identifier: GPL-3.0-or-later
// Polygons alone, as files outside Blender have them: their edges, and a surface of them.
#pragma once

#include <memory>

#include <fovea/mesh/surface.h>

namespace fovea::mesh {

/// The distinct vertex pairs along polygons, numbered by first appearance, and for every corner the edge to the next.
struct PolygonEdges {
    Array<glm::ivec2> edge_verts;
    Array<int> corner_edges;
};
PolygonEdges polygon_edges(In<int> polygon_offsets, In<int> corner_verts);

/// V positions; polygon f has the vertices corner_verts[polygon_offsets[f]] .. [polygon_offsets[f + 1]], 3 or more.
/// Edges follow from them, and polygons with more than four corners are cut into triangles. `material`: a number per
/// polygon, may be empty. Throws as Surface.
std::shared_ptr<Surface> polygon_surface(const std::string& name, In<vec3> positions, In<int> corner_verts,
                                         In<int> polygon_offsets, In<int> material = {});

}  // namespace fovea::mesh
