// SPDX-License-Identifier: GPL-3.0-or-later
// Meshes put in order before anything is derived from them: what no modifier of Blender's does.
#pragma once

#include <fovea/mesh/surface.h>

namespace fovea::repair {

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

/// Its offsets of polygons are there for none, too.
struct RepairedMesh : OwnedMesh {
    RepairReport report;
};

/// Polygons keep their material, edges their marks. Throws std::invalid_argument for a mesh as Surface does and for
/// options out of range.
RepairedMesh repaired(const std::string& name, const MeshArrays& mesh, const Repair& repair);

}  // namespace fovea::repair
