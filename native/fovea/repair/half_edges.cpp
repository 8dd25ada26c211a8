// SPDX-License-Identifier: GPL-3.0-or-later
#include <fovea/repair/half_edges.h>

#include <algorithm>
#include <cmath>

#include <fovea/mesh/polygon_surface.h>

namespace fovea::repair {
namespace {

/// Angle between face normals above which an edge is a feature.
const double feature_angle = glm::radians(40.0);

/// Arrays of edge flags, and the Mark bit of each.
constexpr std::pair<std::vector<std::uint8_t> MeshOf<Owned>::*, Mark> mark_arrays[] = {
    {&OwnedMesh::sharp, mark_sharp}, {&OwnedMesh::seam, mark_seam}, {&OwnedMesh::edge_mark, mark_edge}};

std::uint8_t marks_of(const RepairedMesh& mesh, int edge) {
    std::uint8_t bits = 0;
    for (const auto& [flags, bit] : mark_arrays)
        if (!(mesh.*flags).empty() && (mesh.*flags)[edge]) bits |= bit;
    return bits;
}

/// OpenMesh reports each refused face on standard error; here they are counted instead.
struct Quiet {
    Quiet() { omerr().disable(); }
    ~Quiet() { omerr().enable(); }
};

/// Triangles of a polygon: those given, or a quad split along its shorter diagonal.
std::vector<Triangle> triangles_of(const RepairedMesh& mesh, const NgonTriangles& given, int polygon) {
    const int first = mesh.polygon_offsets[polygon], corners = mesh.polygon_offsets[polygon + 1] - first;
    const auto v = [&](int i) { return Index(mesh.corner_verts[first + i]); };
    const auto apart = [&](int i, int j) {
        return glm::distance(dvec3(mesh.positions[v(i)]), dvec3(mesh.positions[v(j)]));
    };
    if (corners == 3) return {{v(0), v(1), v(2)}};
    if (corners != 4) return {given.of(polygon).begin(), given.of(polygon).end()};
    if (apart(0, 2) <= apart(1, 3)) return {{v(0), v(1), v(2)}, {v(0), v(2), v(3)}};
    return {{v(1), v(2), v(3)}, {v(1), v(3), v(0)}};
}

/// Adds all triangles of a polygon; returns false and adds none if one is refused or there are none.
bool add(HalfEdges& mesh, const std::vector<Triangle>& triangles, int polygon) {
    std::vector<OpenMesh::FaceHandle> added;
    for (const Triangle& t : triangles) {
        const HalfEdges::VertexHandle corners[] = {HalfEdges::VertexHandle(int(t.x)), HalfEdges::VertexHandle(int(t.y)),
                                                   HalfEdges::VertexHandle(int(t.z))};
        const bool places = std::all_of(std::begin(corners), std::end(corners), [&](auto v) {
            const dvec3 p = to_glm(mesh.point(v));
            return std::isfinite(p.x + p.y + p.z);
        });
        const bool corner_twice = t.x == t.y || t.y == t.z || t.z == t.x;
        const auto face = places && !corner_twice ? mesh.add_face(corners, 3) : OpenMesh::SmartFaceHandle();
        if (!face.is_valid()) {
            for (const auto f : added) mesh.delete_face(f, false);
            return false;
        }
        mesh.data(face).polygon = polygon;
        added.push_back(face);
    }
    return !added.empty();
}

/// Calls visit(edge of `mesh`, edge of `source`) for the edges of a polygon that `mesh` has.
template <typename Visit>
void each_edge(HalfEdges& mesh, const RepairedMesh& source, int polygon, const Visit& visit) {
    const int begin = source.polygon_offsets[polygon], end = source.polygon_offsets[polygon + 1];
    for (int c = begin; c < end; ++c) {
        const HalfEdges::VertexHandle a(source.corner_verts[c]), b(source.corner_verts[c + 1 < end ? c + 1 : begin]);
        const auto h = mesh.find_halfedge(a, b);
        if (h.is_valid()) visit(mesh.edge_handle(h), source.corner_edges[c]);
    }
}

void mark_features(HalfEdges& mesh, const RepairedMesh& source) {
    mesh.find_feature_edges(feature_angle);
    for (const auto e : mesh.edges()) {
        bool feature = e.feature() || e.is_boundary() || mesh.data(e).marks || mesh.data(e).held;
        if (!feature) {
            const int p = mesh.data(e.h0().face()).polygon, q = mesh.data(e.h1().face()).polygon;
            const auto differs = [&](const auto& values) { return !values.empty() && values[p] != values[q]; };
            feature = differs(source.material) || differs(source.occluding) || differs(source.one_sided);
        }
        if (!feature) continue;
        mesh.status(e).set_feature(true);
        mesh.status(e.v0()).set_locked(true);
        mesh.status(e.v1()).set_locked(true);
    }
}

}  // namespace

Triangulated::Triangulated(const RepairedMesh& source) : given(source.arrays()) {
    const Quiet quiet;
    for (const vec3& p : source.positions) mesh.add_vertex(from_glm(p));
    for (const auto v : mesh.vertices()) mesh.data(v).number = static_cast<Index>(v.idx());
    std::vector<int> taken;
    for (int f = 0; f + 1 < static_cast<int>(source.polygon_offsets.size()); ++f)
        (add(mesh, triangles_of(source, given, f), f) ? taken : refused).push_back(f);
    for (const int f : taken)
        each_edge(mesh, source, f, [&](auto e, int edge) { mesh.data(e).marks = marks_of(source, edge); });
    for (const int f : refused) {
        each_edge(mesh, source, f, [&](auto e, int) { mesh.data(e).held = true; });
        for (int c = source.polygon_offsets[f]; c < source.polygon_offsets[f + 1]; ++c)
            mesh.status(HalfEdges::VertexHandle(source.corner_verts[c])).set_locked(true);
    }
    mesh.garbage_collection();
    mark_features(mesh, source);
}

RepairedMesh Triangulated::arrays(const RepairedMesh& source) const {
    RepairedMesh out;
    out.report = source.report;
    out.polygon_offsets = {0};
    std::vector<int> number(source.positions.size(), -1);
    for (const auto v : mesh.vertices()) {
        out.positions.push_back(to_glm(mesh.point(v)));
        if (mesh.data(v).number != none) number[mesh.data(v).number] = v.idx();
    }
    std::vector<std::uint8_t> corner_marks;  // marks of the edges that start at corners
    const auto finish = [&](int polygon) {
        out.polygon_offsets.push_back(static_cast<int>(out.corner_verts.size()));
        if (!source.material.empty()) out.material.push_back(source.material[polygon]);
        if (!source.occluding.empty()) out.occluding.push_back(source.occluding[polygon]);
        if (!source.one_sided.empty()) out.one_sided.push_back(source.one_sided[polygon]);
    };
    for (const auto f : mesh.faces()) {
        for (const auto h : f.halfedges()) {
            out.corner_verts.push_back(h.from().idx());
            corner_marks.push_back(mesh.data(h.edge()).marks);
        }
        finish(mesh.data(f).polygon);
    }
    for (const int f : refused) {
        for (int c = source.polygon_offsets[f]; c < source.polygon_offsets[f + 1]; ++c) {
            out.corner_verts.push_back(number[source.corner_verts[c]]);
            corner_marks.push_back(marks_of(source, source.corner_edges[c]));
        }
        for (const Triangle& v : given.of(f)) {
            out.ngon_triangles.push_back({number[v.x], number[v.y], number[v.z]});
            out.ngon_polygon.push_back(static_cast<int>(out.polygon_offsets.size()) - 1);
        }
        finish(f);
    }
    const PolygonEdges edges = polygon_edges(out.polygon_offsets, out.corner_verts);
    out.edge_verts.assign(edges.edge_verts.begin(), edges.edge_verts.end());
    out.corner_edges.assign(edges.corner_edges.begin(), edges.corner_edges.end());
    for (const auto& [flags, bit] : mark_arrays) {
        if ((source.*flags).empty()) continue;
        (out.*flags).resize(out.edge_verts.size());
        for (std::size_t c = 0; c < corner_marks.size(); ++c)
            (out.*flags)[out.corner_edges[c]] |= (corner_marks[c] & bit) != 0;
    }
    return out;
}

}  // namespace fovea::repair
