// SPDX-License-Identifier: GPL-3.0-or-later
// Half-edge meshes of triangles, in which OpenMesh edits.
#pragma once

#include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>

#include <fovea/repair/repair.h>

namespace fovea::repair {

struct HalfEdgeTraits : OpenMesh::DefaultTraitsDouble {
    VertexAttributes(OpenMesh::Attributes::Status | OpenMesh::Attributes::Normal);
    EdgeAttributes(OpenMesh::Attributes::Status);
    FaceAttributes(OpenMesh::Attributes::Status | OpenMesh::Attributes::Normal);
    VertexTraits { Index number = none; };  ///< vertex number in the source mesh; none: created since
    EdgeTraits {
        std::uint8_t marks = 0;  ///< Mark bits
        bool held = false;       ///< a refused polygon has this edge: it must not be split
    };
    FaceTraits { int polygon = 0; };  ///< in the source mesh
};
using HalfEdges = OpenMesh::TriMesh_ArrayKernelT<HalfEdgeTraits>;

/// Triangles of a mesh's polygons, except polygons that OpenMesh refuses (non-manifold ones: the later ones of a fan).
/// Edges that must stay in place (see resample.h) have the status `feature`; their vertices and those of refused
/// polygons have the status `locked`.
struct Triangulated {
    HalfEdges mesh;
    std::vector<int> refused;  ///< polygon indices
    NgonTriangles given;       ///< of the source mesh

    explicit Triangulated(const RepairedMesh& source);
    /// The triangles, followed by the refused polygons of `source`, the mesh it was built from; copies its report.
    RepairedMesh arrays(const RepairedMesh& source) const;
};

inline dvec3 to_glm(const OpenMesh::Vec3d& p) { return {p[0], p[1], p[2]}; }
inline OpenMesh::Vec3d from_glm(const dvec3& p) { return {p.x, p.y, p.z}; }

}  // namespace fovea::repair
