// SPDX-License-Identifier: GPL-3.0-or-later
#include <fovea/repair/resample.h>

#include <OpenMesh/Tools/Decimater/DecimaterT.hh>
#include <OpenMesh/Tools/Decimater/ModEdgeLengthT.hh>
#include <OpenMesh/Tools/Decimater/ModNormalFlippingT.hh>
#include <OpenMesh/Tools/Smoother/JacobiLaplaceSmootherT.hh>
#include <cmath>

#include <fovea/base/elementary.h>
#include <fovea/base/parallel.h>
#include <fovea/repair/half_edges.h>
#include <fovea/scene/nearest.h>

namespace fovea::repair {
namespace {

/// Limit of the change of a triangle's normal in a collapse; 0.2 is its cosine.
constexpr double most_turned = 78.46;  // degrees

/// Polls the thread's Cancel once in a thousand calls.
void poll_sometimes(int call) {
    if (call % 1024 == 0) Cancelling::poll();
}

/// Collapses the shortest edge first, and none whose collapse would create an edge that the next iteration splits.
struct ShortestFirst : OpenMesh::Decimater::ModBaseT<HalfEdges> {
    using Handle = OpenMesh::Decimater::ModHandleT<ShortestFirst>;
    DECIMATER_MODNAME(ShortestFirst)
    explicit ShortestFirst(HalfEdges& mesh) : ModBaseT(mesh, false) {}
    float collapse_priority(const CollapseInfo& collapse) override {
        poll_sometimes(++looks);
        for (const auto v : mesh().vv_range(collapse.v0))
            if (OpenMesh::norm(mesh().point(v) - collapse.p1) > longest) return float(ILLEGAL_COLLAPSE);
        return static_cast<float>(OpenMesh::norm(collapse.p1 - collapse.p0));
    }
    double longest = 0.0;
    int looks = 0;
};

void split_long(HalfEdges& mesh, double longest) {
    // Only edges that exist now; halves that are still too long are split in the next iteration.
    const int edges = static_cast<int>(mesh.n_edges());
    for (int i = 0; i < edges; ++i) {
        poll_sometimes(i);
        const auto e = OpenMesh::make_smart(HalfEdges::EdgeHandle(i), mesh);
        if (mesh.data(e).held || mesh.calc_edge_length(e) <= longest) continue;
        const auto a = e.v0(), b = e.v1();
        const auto middle = mesh.split_copy(e, mesh.calc_edge_midpoint(e));
        mesh.status(middle).set_locked(e.feature());
        for (const auto h : middle.outgoing_halfedges()) {
            if (h.to() == a || h.to() == b) continue;
            mesh.status(h.edge()).set_feature(false);  // split_copy copies the flags of the split edge
            mesh.data(h.edge()).marks = 0;
        }
    }
}

void collapse_short(HalfEdges& mesh, double shortest, double longest) {
    mesh.update_face_normals();
    OpenMesh::Decimater::DecimaterT<HalfEdges> decimater(mesh);
    OpenMesh::Decimater::ModEdgeLengthT<HalfEdges>::Handle length;
    OpenMesh::Decimater::ModNormalFlippingT<HalfEdges>::Handle flipping;
    ShortestFirst::Handle order;
    decimater.add(length);
    decimater.add(flipping);
    decimater.add(order);
    decimater.module(length).set_edge_length(static_cast<float>(shortest));
    decimater.module(flipping).set_max_normal_deviation(most_turned);
    decimater.module(order).longest = longest;
    decimater.initialize();
    // Only vertices at short edges are candidates.
    const auto is_short = [&](const auto& e) { return mesh.calc_edge_length(e) <= shortest; };
    for (const auto v : mesh.vertices()) mesh.status(v).set_selected(v.edges().any_of(is_short));
    decimater.decimate(0, true);
    mesh.garbage_collection();
    for (const auto v : mesh.vertices()) mesh.status(v).set_selected(false);  // the smoother reads this flag, too
}

/// Whether flipping an edge brings the valences of the four vertices around it closer to 6 (on borders 4).
bool evens_out(const OpenMesh::SmartEdgeHandle& e) {
    const auto off = [&](const OpenMesh::SmartVertexHandle& v, int change) {
        const int d = static_cast<int>(v.valence()) + change - (v.is_boundary() ? 4 : 6);
        return d * d;
    };
    const auto a = e.v0(), b = e.v1(), c = e.h0().next().to(), d = e.h1().next().to();
    return off(a, -1) + off(b, -1) + off(c, 1) + off(d, 1) < off(a, 0) + off(b, 0) + off(c, 0) + off(d, 0);
}

/// Whether both triangles, after flipping an edge, face roughly as the two before (cosine above 0.2).
bool faces_well(const HalfEdges& mesh, const OpenMesh::SmartEdgeHandle& e) {
    const auto at = [&](const OpenMesh::SmartVertexHandle& v) { return to_glm(mesh.point(v)); };
    const dvec3 a = at(e.h0().from()), b = at(e.h0().to()), c = at(e.h0().next().to()), d = at(e.h1().next().to());
    const dvec3 before = glm::cross(b - a, c - a) + glm::cross(a - b, d - b);
    const auto faces = [&](const dvec3& n) { return glm::dot(n, before) > 0.2 * glm::length(n) * glm::length(before); };
    return faces(glm::cross(d - c, a - c)) && faces(glm::cross(c - d, b - d));
}

void even_out_valences(HalfEdges& mesh) {
    for (const auto e : mesh.edges()) {
        poll_sometimes(e.idx());
        if (!e.feature() && !e.is_boundary() && mesh.is_flip_ok(e) && evens_out(e) && faces_well(mesh, e)) mesh.flip(e);
    }
}

void relax(HalfEdges& mesh, const NearestPoint& surface) {
    using Smoother = OpenMesh::Smoother::JacobiLaplaceSmootherT<HalfEdges>;
    Smoother smoother(mesh);
    smoother.initialize(Smoother::Tangential, Smoother::C0);
    smoother.smooth(1);
    parallel_for(mesh.n_vertices(), 256, [&](std::size_t i) {
        const HalfEdges::VertexHandle v(static_cast<int>(i));
        if (mesh.status(v).locked() || mesh.is_isolated(v)) return;
        if (const auto p = surface(vec3(to_glm(mesh.point(v))))) mesh.set_point(v, from_glm(*p));
    });
}

double mean_edge(const HalfEdges& mesh) {
    double sum = 0.0;
    for (const auto e : mesh.edges()) sum += mesh.calc_edge_length(e);
    return mesh.n_edges() ? sum / double(mesh.n_edges()) : 0.0;
}

/// About the number of triangles of that side length on the mesh, or of those that so many steps, which divide each
/// triangle into four at most, make: whichever is less.
double expected_triangles(const HalfEdges& mesh, int steps, double length) {
    double area = 0.0;
    for (const auto f : mesh.faces()) area += mesh.calc_face_area(f);
    const double even = area / (std::sqrt(3.0) / 4.0 * length * length);
    return std::min(even, double(mesh.n_faces()) * power(4.0, steps));
}

NearestPoint surface_of(const HalfEdges& mesh) {
    Array<vec3> positions;
    Array<Triangle> triangles;
    for (const auto v : mesh.vertices()) positions.push_back(vec3(to_glm(mesh.point(v))));
    for (const auto f : mesh.faces()) {
        const auto h = f.halfedge();
        triangles.push_back(Triangle(h.from().idx(), h.to().idx(), h.next().to().idx()));
    }
    return {std::move(positions), std::move(triangles)};
}

}  // namespace

void resample(RepairedMesh& source, int steps, double length, std::uint64_t most) {
    Triangulated triangulated(source);
    HalfEdges& mesh = triangulated.mesh;
    source.report.refused_polygons = static_cast<Index>(triangulated.refused.size());
    if (!(length > 0.0)) length = mean_edge(mesh);
    if (!(length > 0.0)) return;
    const double expected = expected_triangles(mesh, steps, length);
    if (!(expected <= double(most))) {
        constexpr double countless = 1e18;
        source.report = {.turned_polygons = source.report.turned_polygons,
                         .too_many_triangles = std::uint64_t(std::min(expected, countless))};
        return;
    }
    const NearestPoint surface = surface_of(mesh);
    const double shortest = 4.0 / 5.0 * length, longest = 4.0 / 3.0 * length;
    for (int i = 0; i < steps; ++i) {
        split_long(mesh, longest);
        collapse_short(mesh, shortest, longest);
        even_out_valences(mesh);
        relax(mesh, surface);
    }
    source = triangulated.arrays(source);
}

}  // namespace fovea::repair
