// SPDX-License-Identifier: GPL-3.0-or-later
// Mesh repair that no Blender modifier does, applied before anything is derived from the mesh.
#pragma once

#include <fovea/mesh/surface.h>

namespace fovea::repair {

/// Repair steps, in this order; all are off by default.
struct Repair {
    bool orient = false;       ///< make neighbors agree, closed parts face outwards: see orient.h
    int resample = 0;          ///< number of remeshing iterations (see resample.h), 0 to 100
    double edge_length = 0.0;  ///< target edge length of remeshing, in object units; 0: the mesh's mean
    std::uint64_t most_triangles = std::uint64_t(1) << 30;  ///< a mesh of which remeshing makes more is not remeshed
};

/// What was done; counts of elements.
struct RepairReport {
    Index turned_polygons = 0;
    Index refused_polygons = 0;            ///< non-manifold: not resampled, kept as they were
    std::uint64_t too_many_triangles = 0;  ///< about as many as remeshing would have made; 0: it was done
};

/// polygon_offsets is {0}, not empty, for a mesh without polygons.
struct RepairedMesh : OwnedMesh {
    RepairReport report;
};

/// Polygons keep their material, and edges their marks. Throws std::invalid_argument, naming the object, for an invalid
/// mesh (as Surface does) and for options out of range.
RepairedMesh repaired(const std::string& name, const MeshArrays& mesh, const Repair& repair);

}  // namespace fovea::repair
