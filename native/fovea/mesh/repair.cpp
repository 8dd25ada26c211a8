// SPDX-License-Identifier: GPL-3.0-or-later
#include <fovea/mesh/repair.h>

#include <algorithm>

#include <fovea/base/check.h>
#include <fovea/mesh/polygon_edges.h>
#include <fovea/mesh/repair_polygons.h>

namespace fovea {
namespace {

RepairedMesh mesh_of(const Polygons& all, const MeshArrays& mesh) {
    RepairedMesh out;
    out.positions.assign(all.positions.begin(), all.positions.end());
    for (const Polygon& polygon : all.polygons) {
        out.corner_verts.insert(out.corner_verts.end(), polygon.vertices.begin(), polygon.vertices.end());
        out.polygon_offsets.push_back(static_cast<int>(out.corner_verts.size()));
        if (!mesh.material.empty()) out.material.push_back(mesh.material[polygon.origin]);
        if (!mesh.occluding.empty()) out.occluding.push_back(mesh.occluding[polygon.origin]);
        for (const Triangle& t : polygon.triangles) {
            out.ngon_triangles.push_back(glm::ivec3(t));
            out.ngon_polygon.push_back(static_cast<int>(out.polygon_offsets.size()) - 2);
        }
    }
    const PolygonEdges edges = polygon_edges(out.polygon_offsets, out.corner_verts);
    out.edge_verts.assign(edges.edge_verts.begin(), edges.edge_verts.end());
    out.corner_edges.assign(edges.corner_edges.begin(), edges.corner_edges.end());
    if (all.marks.empty()) return out;
    for (auto* flags : {&out.sharp, &out.seam, &out.edge_mark}) flags->resize(out.edge_verts.size());
    for (std::size_t e = 0; e < out.edge_verts.size(); ++e) {
        const std::uint8_t bits = all.marks.at(out.edge_verts[e].x, out.edge_verts[e].y);
        out.sharp[e] = (bits & mark_sharp) != 0;
        out.seam[e] = (bits & mark_seam) != 0;
        out.edge_mark[e] = (bits & mark_edge) != 0;
    }
    return out;
}

}  // namespace

MeshArrays RepairedMesh::arrays() const {
    return {positions, edge_verts, corner_verts, corner_edges, polygon_offsets, ngon_triangles, ngon_polygon,
            material,  occluding,  sharp,        seam,         edge_mark};
}

Polygons polygons_of(const MeshArrays& mesh) {
    Polygons all;
    all.positions.assign(mesh.positions.begin(), mesh.positions.end());
    const std::size_t count = mesh.polygon_offsets.empty() ? 0 : mesh.polygon_offsets.size() - 1;
    all.polygons.resize(count);
    for (std::size_t f = 0; f < count; ++f) {
        const auto corners = mesh.corner_verts.begin();
        all.polygons[f].vertices.assign(corners + mesh.polygon_offsets[f], corners + mesh.polygon_offsets[f + 1]);
        all.polygons[f].origin = static_cast<int>(f);
    }
    for (std::size_t t = 0; t < mesh.ngon_triangles.size(); ++t)
        all.polygons[mesh.ngon_polygon[t]].triangles.push_back(Triangle(mesh.ngon_triangles[t]));
    const auto mark = [&](In<std::uint8_t> flags, Mark bit) {
        for (std::size_t e = 0; e < flags.size(); ++e)
            if (flags[e]) all.marks.add(mesh.edge_verts[e].x, mesh.edge_verts[e].y, bit);
    };
    mark(mesh.sharp, mark_sharp);
    mark(mesh.seam, mark_seam);
    mark(mesh.edge_mark, mark_edge);
    return all;
}

RepairedMesh repaired(const std::string& name, const MeshArrays& mesh, const Repair& repair) {
    check_mesh(name, mesh);
    check(repair.weld >= 0.0 && repair.edge_length >= 0.0, name + ": repair: lengths must not be negative");
    check(repair.smooth >= 0 && repair.smooth <= 1000, name + ": repair: 0 to 1000 steps of smoothing are possible");
    check(repair.resample >= 0 && repair.resample <= 100, name + ": repair: 0 to 100 steps of resampling are possible");
    Polygons all = polygons_of(mesh);
    RepairReport report;
    if (repair.weld > 0.0) report.welded_vertices = weld(all, repair.weld);
    if (repair.orient) report.turned_polygons = orient(all);
    if (repair.smooth > 0 || repair.resample > 0) report.refused_polygons = remesh(all, repair, mesh);
    RepairedMesh result = mesh_of(all, mesh);
    result.report = report;
    return result;
}

}  // namespace fovea
