// SPDX-License-Identifier: GPL-3.0-or-later
// Smoothing and resampling, by OpenMesh.
#include <OpenMesh/Core/Mesh/PolyMesh_ArrayKernelT.hh>
#include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>
#include <OpenMesh/Tools/Smoother/JacobiLaplaceSmootherT.hh>
#include <algorithm>
#include <cmath>

#include <fovea/base/parallel.h>
#include <fovea/mesh/nearest.h>
#include <fovea/mesh/repair_polygons.h>

namespace fovea {
namespace {

struct Traits : OpenMesh::DefaultTraitsDouble {
    VertexAttributes(OpenMesh::Attributes::Status);
    EdgeAttributes(OpenMesh::Attributes::Status);
    FaceAttributes(OpenMesh::Attributes::Status);
};
using PolyMesh = OpenMesh::PolyMesh_ArrayKernelT<Traits>;
using TriMesh = OpenMesh::TriMesh_ArrayKernelT<Traits>;
using Vertex = OpenMesh::VertexHandle;
using Side = OpenMesh::EdgeHandle;
using Half = OpenMesh::HalfedgeHandle;
using Face = OpenMesh::FaceHandle;

/// Cosine of the angle between polygons from which their edge is a feature.
const double feature_cosine = std::cos(glm::radians(40.0));

dvec3 to_glm(const OpenMesh::Vec3d& p) { return {p[0], p[1], p[2]}; }
OpenMesh::Vec3d from_glm(const dvec3& p) { return {p.x, p.y, p.z}; }

/// OpenMesh tells of what it refuses on standard error; here it is counted instead.
struct Quiet {
    Quiet() { omerr().disable(); }
    ~Quiet() { omerr().enable(); }
};

/// The polygons that OpenMesh takes, vertices numbered as they were. Features are marked in the status of edges and
/// vertices; vertices of polygons that it refuses are locked.
template <typename Mesh>
struct Taken {
    Mesh mesh;
    OpenMesh::FPropHandleT<int> origin;
    OpenMesh::EPropHandleT<int> marks;
    std::vector<Polygon> accepted, refused;

    Taken(const Polygons& all, const std::vector<Polygon>& polygons, const MeshArrays& source) {
        const Quiet quiet;
        mesh.add_property(origin);
        mesh.add_property(marks);
        for (const dvec3& p : all.positions) mesh.add_vertex(from_glm(p));
        std::vector<Vertex> corners;
        for (const Polygon& polygon : polygons) {
            corners.clear();
            for (Index v : polygon.vertices) corners.push_back(Vertex(int(v)));
            const Face face = takes(all, polygon) ? Face(mesh.add_face(corners)) : Face();
            (face.is_valid() ? accepted : refused).push_back(polygon);
            if (face.is_valid()) mesh.property(origin, face) = polygon.origin;
        }
        lock(refused);
        for (Side e : mesh.edges()) mark_feature(e, all, source);
    }

    void lock(const std::vector<Polygon>& polygons) {
        for (const Polygon& polygon : polygons)
            for (Index v : polygon.vertices) mesh.status(Vertex(int(v))).set_locked(true);
    }

   private:
    static bool takes(const Polygons& all, const Polygon& polygon) {
        std::vector<Index> sorted = polygon.vertices;
        std::sort(sorted.begin(), sorted.end());
        return sorted.size() >= 3 && std::adjacent_find(sorted.begin(), sorted.end()) == sorted.end() &&
               std::all_of(sorted.begin(), sorted.end(), [&](Index v) {
                   const dvec3& p = all.positions[v];
                   return std::isfinite(p.x + p.y + p.z);
               });
    }

    void mark_feature(Side e, const Polygons& all, const MeshArrays& source) {
        const Half h = mesh.halfedge_handle(e, 0), o = mesh.halfedge_handle(e, 1);
        const Vertex a = mesh.from_vertex_handle(h), b = mesh.to_vertex_handle(h);
        mesh.property(marks, e) = all.marks.at(Index(a.idx()), Index(b.idx()));
        bool feature = mesh.property(marks, e) != 0 || mesh.is_boundary(e);
        if (!feature) {
            const Face f = mesh.face_handle(h), g = mesh.face_handle(o);
            const int p = mesh.property(origin, f), q = mesh.property(origin, g);
            const auto differs = [&](const auto& values) { return !values.empty() && values[p] != values[q]; };
            feature = differs(source.material) || differs(source.occluding) ||
                      OpenMesh::dot(mesh.calc_face_normal(f), mesh.calc_face_normal(g)) < feature_cosine;
        }
        if (!feature) return;
        mesh.status(e).set_feature(true);
        mesh.status(a).set_feature(true);
        mesh.status(b).set_feature(true);
    }
};

void smooth(Polygons& all, int steps, const MeshArrays& source) {
    Taken<PolyMesh> taken(all, all.polygons, source);
    PolyMesh& mesh = taken.mesh;
    OpenMesh::Smoother::JacobiLaplaceSmootherT<PolyMesh> smoother(mesh);
    smoother.skip_features(true);
    smoother.initialize(decltype(smoother)::Tangential_and_Normal, decltype(smoother)::C1);
    smoother.smooth(static_cast<unsigned>(steps));
    for (std::size_t v = 0; v < all.positions.size(); ++v) {
        const Vertex vertex(static_cast<int>(v));
        if (!mesh.is_isolated(vertex)) all.positions[v] = to_glm(mesh.point(vertex));
    }
}

/// Triangles of a polygon: its own, or a quad's by the shorter diagonal.
void add_triangles(const Polygons& all, const Polygon& polygon, std::vector<Polygon>& out) {
    const auto& v = polygon.vertices;
    const auto at = [&](int i) { return all.positions[v[i]]; };
    if (v.size() == 3) {
        out.push_back(polygon);
    } else if (v.size() == 4) {
        const int first = glm::distance(at(0), at(2)) <= glm::distance(at(1), at(3)) ? 0 : 1;
        out.push_back({{v[first], v[first + 1], v[first + 2]}, polygon.origin});
        out.push_back({{v[first], v[first + 2], v[(first + 3) % 4]}, polygon.origin});
    } else {
        for (const Triangle& t : polygon.triangles) out.push_back({{t.x, t.y, t.z}, polygon.origin});
    }
}

/// One mesh on its way to equal edges. Feature vertices never move.
class Resampling {
   public:
    Resampling(Taken<TriMesh>& taken, const NearestPoint& surface, double length)
        : taken_(taken), mesh_(taken.mesh), surface_(surface), length_(length) {}

    void step() {
        split_long();
        collapse_short();
        flip();
        relax();
    }

   private:
    bool fixed(Vertex v) const {
        const auto& status = mesh_.status(v);
        return status.feature() || status.locked() || mesh_.is_boundary(v);
    }
    dvec3 at(Vertex v) const { return to_glm(mesh_.point(v)); }
    double length2(const dvec3& d) const { return glm::dot(d, d); }

    void split_long() {
        // Those that are there now; their halves wait for the next step.
        const double longest2 = std::pow(4.0 / 3.0 * length_, 2);
        const int edges = static_cast<int>(mesh_.n_edges());
        for (int i = 0; i < edges; ++i) {
            const Side e(i);
            if (mesh_.status(e).deleted()) continue;
            const Half h = mesh_.halfedge_handle(e, 0);
            const Vertex a = mesh_.from_vertex_handle(h), b = mesh_.to_vertex_handle(h);
            const bool beside_refused = mesh_.is_boundary(e) && mesh_.status(a).locked() && mesh_.status(b).locked();
            if (length2(at(b) - at(a)) > longest2 && !beside_refused) split(e, a, b);
        }
    }

    void split(Side e, Vertex a, Vertex b) {
        const bool feature = mesh_.status(e).feature();
        const int marks = mesh_.property(taken_.marks, e);
        // A triangle's origin goes to both halves, which are told by the corner across.
        std::vector<std::pair<Vertex, int>> across;
        for (int side = 0; side < 2; ++side) {
            const Half h = mesh_.halfedge_handle(e, side);
            if (mesh_.is_boundary(h)) continue;
            across.emplace_back(mesh_.to_vertex_handle(mesh_.next_halfedge_handle(h)),
                                mesh_.property(taken_.origin, mesh_.face_handle(h)));
        }
        const Vertex middle = mesh_.add_vertex(from_glm(0.5 * (at(a) + at(b))));
        mesh_.split(e, middle);
        mesh_.status(middle).set_feature(feature);
        for (Half h : mesh_.voh_range(middle)) {
            const Vertex to = mesh_.to_vertex_handle(h);
            const Side part = mesh_.edge_handle(h);
            const bool along = to == a || to == b;
            mesh_.status(part).set_feature(along && feature);
            mesh_.property(taken_.marks, part) = along ? marks : 0;
        }
        for (Face f : mesh_.vf_range(middle))
            for (Vertex v : mesh_.fv_range(f))
                for (const auto& [corner, origin] : across)
                    if (v == corner) mesh_.property(taken_.origin, f) = origin;
    }

    void collapse_short() {
        const double shortest2 = std::pow(4.0 / 5.0 * length_, 2);
        const int edges = static_cast<int>(mesh_.n_edges());
        for (int i = 0; i < edges; ++i) {
            const Side e(i);
            if (mesh_.status(e).deleted() || mesh_.status(e).feature()) continue;
            for (int side = 0; side < 2; ++side) {
                const Half h = mesh_.halfedge_handle(e, side);
                if (length2(at(mesh_.to_vertex_handle(h)) - at(mesh_.from_vertex_handle(h))) >= shortest2) break;
                if (may_collapse(h)) {
                    collapse(h);
                    break;
                }
            }
        }
        mesh_.garbage_collection();
    }

    bool may_collapse(Half h) {
        const Vertex gone = mesh_.from_vertex_handle(h), kept = mesh_.to_vertex_handle(h);
        if (fixed(gone) || mesh_.status(kept).locked() || !mesh_.is_collapse_ok(h)) return false;
        const double longest2 = std::pow(4.0 / 3.0 * length_, 2);
        for (Vertex v : mesh_.vv_range(gone))
            if (length2(at(v) - at(kept)) > longest2) return false;
        // No triangle may turn over.
        for (Half out : mesh_.voh_range(gone)) {
            const Vertex b = mesh_.to_vertex_handle(out), c = mesh_.to_vertex_handle(mesh_.next_halfedge_handle(out));
            if (b == kept || c == kept) continue;
            if (turns_over(at(gone), at(kept), at(b), at(c))) return false;
        }
        return true;
    }

    /// Whether triangle abc changes its side, or loses its area, when `from` goes to `to`.
    static bool turns_over(const dvec3& from, const dvec3& to, const dvec3& b, const dvec3& c) {
        const dvec3 before = glm::cross(b - from, c - from), after = glm::cross(b - to, c - to);
        return glm::dot(before, after) <= 0.2 * glm::length(before) * glm::length(after);
    }

    void collapse(Half h) {
        // Of the two edges that become one the kept vertex' own says what it is.
        const Vertex kept = mesh_.to_vertex_handle(h);
        struct Own {
            Vertex end;
            bool feature;
            int marks;
        };
        std::vector<Own> own;
        for (Half out : mesh_.voh_range(kept)) {
            const Side e = mesh_.edge_handle(out);
            own.push_back({mesh_.to_vertex_handle(out), mesh_.status(e).feature(), mesh_.property(taken_.marks, e)});
        }
        mesh_.collapse(h);
        for (Half out : mesh_.voh_range(kept))
            for (const Own& o : own)
                if (o.end == mesh_.to_vertex_handle(out)) {
                    mesh_.status(mesh_.edge_handle(out)).set_feature(o.feature);
                    mesh_.property(taken_.marks, mesh_.edge_handle(out)) = o.marks;
                }
    }

    void flip() {
        const auto off = [&](Vertex v, int change) {
            const int ideal = mesh_.is_boundary(v) ? 4 : 6, d = static_cast<int>(mesh_.valence(v)) + change - ideal;
            return d * d;
        };
        for (Side e : mesh_.edges()) {
            if (mesh_.status(e).feature() || mesh_.is_boundary(e) || !mesh_.is_flip_ok(e)) continue;
            const Half h = mesh_.halfedge_handle(e, 0), o = mesh_.halfedge_handle(e, 1);
            const Vertex a = mesh_.from_vertex_handle(h), b = mesh_.to_vertex_handle(h);
            const Vertex c = mesh_.to_vertex_handle(mesh_.next_halfedge_handle(h));
            const Vertex d = mesh_.to_vertex_handle(mesh_.next_halfedge_handle(o));
            const int before = off(a, 0) + off(b, 0) + off(c, 0) + off(d, 0);
            const int after = off(a, -1) + off(b, -1) + off(c, 1) + off(d, 1);
            // cda and dcb instead of abc and bad, neither of them turned over.
            const dvec3 n = glm::cross(at(b) - at(a), at(c) - at(a)) + glm::cross(at(a) - at(b), at(d) - at(b));
            const dvec3 left = glm::cross(at(d) - at(c), at(a) - at(c));
            const dvec3 right = glm::cross(at(c) - at(d), at(b) - at(d));
            const auto faces_well = [&](const dvec3& m) {
                return glm::dot(m, n) > 0.2 * glm::length(m) * glm::length(n);
            };
            if (after < before && faces_well(left) && faces_well(right)) mesh_.flip(e);
        }
    }

    void relax() {
        const auto count = mesh_.n_vertices();
        std::vector<dvec3> moved(count);
        parallel_for(
            count,
            [&](std::size_t i) {
                const Vertex v(static_cast<int>(i));
                moved[i] = at(v);
                if (fixed(v) || mesh_.is_isolated(v)) return;
                dvec3 sum(0.0), normal(0.0);
                int neighbours = 0;
                for (auto it = mesh_.cvoh_iter(v); it.is_valid(); ++it) {
                    const dvec3 b = at(mesh_.to_vertex_handle(*it));
                    const dvec3 c = at(mesh_.to_vertex_handle(mesh_.next_halfedge_handle(*it)));
                    normal += glm::cross(b - moved[i], c - moved[i]);
                    sum += b;
                    ++neighbours;
                }
                if (!(glm::length(normal) > 0.0)) return;
                normal = glm::normalize(normal);
                const dvec3 step = sum / double(neighbours) - moved[i];
                moved[i] = surface_.to(moved[i] + step - glm::dot(step, normal) * normal);
            },
            256);
        for (std::size_t i = 0; i < count; ++i) mesh_.set_point(Vertex(static_cast<int>(i)), from_glm(moved[i]));
    }

    Taken<TriMesh>& taken_;
    TriMesh& mesh_;
    const NearestPoint& surface_;
    double length_;
};

double mean_edge(const TriMesh& mesh) {
    double sum = 0.0;
    for (Side e : mesh.edges()) sum += mesh.calc_edge_length(e);
    return mesh.n_edges() ? sum / double(mesh.n_edges()) : 0.0;
}

NearestPoint surface_of(const TriMesh& mesh, double length) {
    std::vector<dvec3> positions;
    std::vector<glm::uvec3> triangles;
    for (Vertex v : mesh.vertices()) positions.push_back(to_glm(mesh.point(v)));
    for (Face f : mesh.faces()) {
        auto it = mesh.cfv_iter(f);
        const Index a = it->idx(), b = (++it)->idx(), c = (++it)->idx();
        triangles.push_back({a, b, c});
    }
    return {std::move(positions), std::move(triangles), length};
}

void resample(Polygons& all, int steps, double length, const MeshArrays& source) {
    const Taken<PolyMesh> whole(all, all.polygons, source);
    std::vector<Polygon> triangles;
    for (const Polygon& polygon : whole.accepted) add_triangles(all, polygon, triangles);
    Taken<TriMesh> taken(all, triangles, source);
    taken.refused.insert(taken.refused.end(), whole.refused.begin(), whole.refused.end());
    taken.lock(whole.refused);
    TriMesh& mesh = taken.mesh;
    if (!(length > 0.0)) length = mean_edge(mesh);
    if (!(length > 0.0)) return;
    const NearestPoint surface = surface_of(mesh, length);
    OpenMesh::VPropHandleT<int> number;  // as it was, for what refused polygons hold on to
    mesh.add_property(number);
    for (Vertex v : mesh.vertices()) mesh.property(number, v) = v.idx();
    Resampling resampling(taken, surface, length);
    for (int i = 0; i < steps; ++i) resampling.step();

    std::vector<Index> new_number(all.positions.size(), none);
    all.positions.clear();
    for (Vertex v : mesh.vertices()) {
        all.positions.push_back(to_glm(mesh.point(v)));
        const int before = mesh.property(number, v);
        if (mesh.status(v).locked()) new_number[before] = static_cast<Index>(v.idx());
    }
    all.polygons.clear();
    for (Face f : mesh.faces()) {
        Polygon triangle{{}, mesh.property(taken.origin, f)};
        for (Vertex v : mesh.fv_range(f)) triangle.vertices.push_back(static_cast<Index>(v.idx()));
        all.polygons.push_back(std::move(triangle));
    }
    EdgeMarks marks;
    for (Side e : mesh.edges()) {
        const Half h = mesh.halfedge_handle(e, 0);
        marks.add(Index(mesh.from_vertex_handle(h).idx()), Index(mesh.to_vertex_handle(h).idx()),
                  static_cast<std::uint8_t>(mesh.property(taken.marks, e)));
    }
    all.marks.each([&](Index a, Index b, std::uint8_t bits) {
        if (new_number[a] != none && new_number[b] != none) marks.add(new_number[a], new_number[b], bits);
    });
    all.marks = std::move(marks);
    for (Polygon& polygon : taken.refused) {
        for (Index& v : polygon.vertices) v = new_number[v];
        for (Triangle& t : polygon.triangles) t = {new_number[t.x], new_number[t.y], new_number[t.z]};
        all.polygons.push_back(std::move(polygon));
    }
}

}  // namespace

Index remesh(Polygons& all, const Repair& repair, const MeshArrays& mesh) {
    const Index refused = static_cast<Index>(Taken<PolyMesh>(all, all.polygons, mesh).refused.size());
    if (repair.smooth > 0) smooth(all, repair.smooth, mesh);
    if (repair.resample > 0) resample(all, repair.resample, repair.edge_length, mesh);
    return refused;
}

}  // namespace fovea
