// SPDX-License-Identifier: GPL-3.0-or-later
#include <fovea/repair/repair.h>

#include <fovea/base/check.h>
#include <fovea/repair/orient.h>
#include <fovea/repair/resample.h>

namespace fovea::repair {
namespace {

OwnedMesh owned(const MeshArrays& mesh) {
    const auto own = [](const auto& values) { return std::vector(values.begin(), values.end()); };
    OwnedMesh made{{own(mesh.positions), own(mesh.edge_verts), own(mesh.corner_verts), own(mesh.corner_edges),
                    own(mesh.polygon_offsets), own(mesh.ngon_triangles), own(mesh.ngon_polygon), own(mesh.material),
                    own(mesh.occluding), own(mesh.sharp), own(mesh.seam), own(mesh.edge_mark), own(mesh.smooth),
                    own(mesh.one_sided)}};
    if (made.polygon_offsets.empty()) made.polygon_offsets = {0};
    return made;
}

}  // namespace

RepairedMesh repaired(const std::string& name, const MeshArrays& mesh, const Repair& repair) {
    check_mesh(name, mesh);
    check(repair.edge_length >= 0.0, name + ": repair: lengths must not be negative");
    check(repair.resample >= 0 && repair.resample <= 100, name + ": repair: 0 to 100 steps of resampling are possible");
    RepairedMesh result{owned(mesh), {}};
    if (repair.orient) result.report.turned_polygons = orient(result);
    if (repair.resample > 0) {
        resample(result, repair.resample, repair.edge_length, repair.most_triangles);
        if (result.report.too_many_triangles > 0) return result;
        // Its edges are new: where shading was smooth somewhere, it is now on all that are not marked sharp.
        if (!mesh.smooth.empty()) result.smooth.assign(result.edge_verts.size(), 1);
    }
    return result;
}

}  // namespace fovea::repair
