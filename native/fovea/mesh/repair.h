// SPDX-License-Identifier: GPL-3.0-or-later
// Meshes put in order before anything is derived from them.
#pragma once

#include <fovea/mesh/surface.h>

namespace fovea {

/// What is done, in this order. Lengths are in object units; everything is off at first.
struct Repair {
    double weld = 0.0;         ///< vertices that are not farther apart become one; 0: none
    bool orient = false;       ///< neighbours agree about which side is out, closed parts face outwards
    int smooth = 0;            ///< steps of smoothing
    int resample = 0;          ///< steps towards triangles of equal sides
    double edge_length = 0.0;  ///< of these; 0: the mesh's mean
    bool any() const { return weld > 0.0 || orient || smooth > 0 || resample > 0; }
};

/// How much was done; counts of elements.
struct RepairReport {
    Index welded_vertices = 0;  ///< joined to another one
    Index turned_polygons = 0;
    Index refused_polygons = 0;  ///< non-manifold: neither smoothed nor resampled, kept as they were
};

/// A mesh that owns its arrays.
struct RepairedMesh {
    std::vector<vec3> positions;
    std::vector<glm::ivec2> edge_verts;
    std::vector<int> corner_verts, corner_edges, polygon_offsets{0};
    std::vector<glm::ivec3> ngon_triangles;
    std::vector<int> ngon_polygon, material;
    std::vector<std::uint8_t> occluding, sharp, seam, edge_mark;
    RepairReport report;

    MeshArrays arrays() const;
};

/// Polygons keep their material, edges their marks. Smoothing and resampling leave edges as they are that are borders,
/// marked, between materials, or where polygons meet at more than 40 degrees; resampling may divide them. Polygons
/// become triangles only where they are resampled. Loose edges are left out, polygons that welding leaves without area,
/// too. Throws std::invalid_argument for a mesh as Surface does and for options out of range.
///
/// Botsch & Kobbelt, "A Remeshing Approach to Multiresolution Modeling", SGP 2004 (resampling); Kobbelt et al.,
/// "Interactive Multi-Resolution Modeling on Arbitrary Meshes", SIGGRAPH 1998 (smoothing).
RepairedMesh repaired(const std::string& name, const MeshArrays& mesh, const Repair& repair);

}  // namespace fovea
