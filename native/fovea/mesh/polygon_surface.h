// SPDX-License-Identifier: GPL-3.0-or-later
// Surfaces from plain polygon lists, as files outside Blender have them: edges are derived from the polygons.
#pragma once

#include <memory>

#include <fovea/mesh/surface.h>

namespace fovea::mesh {

/// Distinct vertex pairs along the polygons, numbered by first appearance, and per corner the edge to the next corner.
struct PolygonEdges {
    Array<glm::ivec2> edge_verts;
    Array<int> corner_edges;
};
PolygonEdges polygon_edges(In<int> polygon_offsets, In<int> corner_verts);

/// Builds a Surface. V positions; polygon f has the vertices corner_verts[polygon_offsets[f] .. polygon_offsets[f +
/// 1]), 3 or more. Edges are derived, and polygons with more than four corners are triangulated. `material`: an index
/// per polygon, or empty. Throws as Surface does.
std::shared_ptr<Surface> polygon_surface(const std::string& name, In<vec3> positions, In<int> corner_verts,
                                         In<int> polygon_offsets, In<int> material = {});

}  // namespace fovea::mesh
