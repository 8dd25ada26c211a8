// SPDX-License-Identifier: GPL-3.0-or-later
// Meshes put in order before anything is derived from them: what no modifier of Blender's does.
#pragma once

#include <fovea/mesh/surface.h>

namespace fovea {

/// What is done, in this order; everything is off at first.
struct Repair {
    bool orient = false;       ///< neighbors agree about which side is out, closed parts face outwards: orient.h
    int resample = 0;          ///< steps towards triangles of equal sides: resample.h
    double edge_length = 0.0;  ///< of these, in object units; 0: the mesh's mean
};

/// How much was done; counts of elements.
struct RepairReport {
    Index turned_polygons = 0;
    Index refused_polygons = 0;  ///< non-manifold: not resampled, kept as they were
};

/// A mesh that owns its arrays, as MeshArrays has them.
struct RepairedMesh {
    std::vector<vec3> positions;
    std::vector<glm::ivec2> edge_verts;
    std::vector<int> corner_verts, corner_edges, polygon_offsets{0};
    std::vector<glm::ivec3> ngon_triangles;
    std::vector<int> ngon_polygon, material;
    std::vector<std::uint8_t> occluding, sharp, seam, edge_mark;
    RepairReport report;

    RepairedMesh() = default;
    explicit RepairedMesh(const MeshArrays& mesh);
    MeshArrays arrays() const;
};

/// Polygons keep their material, edges their marks. Throws std::invalid_argument for a mesh as Surface does and for
/// options out of range.
RepairedMesh repaired(const std::string& name, const MeshArrays& mesh, const Repair& repair);

}  // namespace fovea
