// SPDX-License-Identifier: GPL-3.0-or-later
// A mesh as OpenMesh edits it: triangles with half-edges.
#pragma once

#include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>

#include <fovea/repair/repair.h>

namespace fovea::repair {

struct HalfEdgeTraits : OpenMesh::DefaultTraitsDouble {
    VertexAttributes(OpenMesh::Attributes::Status | OpenMesh::Attributes::Normal);
    EdgeAttributes(OpenMesh::Attributes::Status);
    FaceAttributes(OpenMesh::Attributes::Status | OpenMesh::Attributes::Normal);
    VertexTraits { Index number = none; };  ///< in the mesh that it comes from; none: made since
    EdgeTraits {
        std::uint8_t marks = 0;  ///< Mark bits
        bool held = false;       ///< a polygon that was refused runs along it: it must stay whole
    };
    FaceTraits { int polygon = 0; };  ///< of the mesh that it comes from
};
using HalfEdges = OpenMesh::TriMesh_ArrayKernelT<HalfEdgeTraits>;

/// The triangles of a mesh's polygons, but for polygons that OpenMesh refuses (of a fan with others, the later ones).
/// Edges that are to stay where they are have the status `feature` (resample.h says which), and their vertices and
/// those of refused polygons the status `locked`.
struct Triangulated {
    HalfEdges mesh;
    std::vector<int> refused;  ///< polygons

    explicit Triangulated(const RepairedMesh& source);
    /// The triangles, then the refused polygons of the same `source`; its report is handed on.
    RepairedMesh arrays(const RepairedMesh& source) const;
};

inline dvec3 to_glm(const OpenMesh::Vec3d& p) { return {p[0], p[1], p[2]}; }
inline OpenMesh::Vec3d from_glm(const dvec3& p) { return {p.x, p.y, p.z}; }

}  // namespace fovea::repair
