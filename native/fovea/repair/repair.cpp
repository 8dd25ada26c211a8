// SPDX-License-Identifier: GPL-3.0-or-later
#include <fovea/repair/repair.h>

#include <fovea/base/check.h>
#include <fovea/repair/orient.h>
#include <fovea/repair/resample.h>

namespace fovea {
namespace {

template <typename T>
std::vector<T> owned(In<T> values) {
    return {values.begin(), values.end()};
}

}  // namespace

RepairedMesh::RepairedMesh(const MeshArrays& mesh)
    : positions(owned(mesh.positions)),
      edge_verts(owned(mesh.edge_verts)),
      corner_verts(owned(mesh.corner_verts)),
      corner_edges(owned(mesh.corner_edges)),
      ngon_triangles(owned(mesh.ngon_triangles)),
      ngon_polygon(owned(mesh.ngon_polygon)),
      material(owned(mesh.material)),
      occluding(owned(mesh.occluding)),
      sharp(owned(mesh.sharp)),
      seam(owned(mesh.seam)),
      edge_mark(owned(mesh.edge_mark)) {
    if (!mesh.polygon_offsets.empty()) polygon_offsets = owned(mesh.polygon_offsets);
}

MeshArrays RepairedMesh::arrays() const {
    return {positions, edge_verts, corner_verts, corner_edges, polygon_offsets, ngon_triangles, ngon_polygon,
            material,  occluding,  sharp,        seam,         edge_mark};
}

RepairedMesh repaired(const std::string& name, const MeshArrays& mesh, const Repair& repair) {
    check_mesh(name, mesh);
    check(repair.edge_length >= 0.0, name + ": repair: lengths must not be negative");
    check(repair.resample >= 0 && repair.resample <= 100, name + ": repair: 0 to 100 steps of resampling are possible");
    RepairedMesh result(mesh);
    if (repair.orient) result.report.turned_polygons = orient(result);
    if (repair.resample > 0) resample(result, repair.resample, repair.edge_length);
    return result;
}

}  // namespace fovea
