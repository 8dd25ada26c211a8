// SPDX-License-Identifier: GPL-3.0-or-later
// Puts the mesh of a cut-out together from clipped polygons: vertices shared by neighbors, edges with their marks.
#include <algorithm>
#include <cmath>
#include <map>
#include <unordered_map>

#include <fovea/base/parallel.h>
#include <fovea/cutout/clipped_mesh.h>
#include <fovea/mesh/ears.h>
#include <fovea/mesh/polygon_surface.h>

namespace fovea::cutout {
namespace {

constexpr double same_point = 1e-6;  // points on a side closer than this share of it are one

}  // namespace

/// Puts a CutMesh together, polygon by polygon.
class Builder {
   public:
    Builder(CutMesh& made, const MeshArrays& mesh, const std::vector<Cut>& cuts, const CutOptions& options)
        : made_(made), mesh_(mesh), cuts_(cuts), options_(options), clipped_(mesh, cuts, options) {}

    void build() {
        collect_side_points();
        made_.positions.assign(mesh_.positions.begin(), mesh_.positions.end());
        add_side_points();
        made_.polygon_offsets = {0};
        for (std::size_t f = 0; f < clipped_.polygons.size(); ++f) add_polygon(f);
        add_edges();
        const Array<vec3> all = made_.moved(mesh_.positions);
        made_.positions.assign(all.begin(), all.end());
        triangulate();
    }

   private:
    using SideKey = std::pair<Index, Index>;  // its vertices, the lower one first
    struct SidePoint {
        SideKey side;
        double t;
        auto operator<=>(const SidePoint&) const = default;
    };

    SideKey side_of(const Corners& corners, Index number) const {
        const Index a = mesh_.corner_verts[corners[number]], b = mesh_.corner_verts[corners[(number + 1) % 3]];
        return std::minmax(a, b);
    }

    void collect_side_points() {
        for (const ClippedPolygon& polygon : clipped_.polygons) {
            if (polygon.what != Clipped::part) continue;
            for (const auto& [corners, clipped] : polygon.triangles)
                for (const auto& piece : clipped.pieces)
                    for (const PieceCorner& c : piece)
                        if (c.kind == PieceCorner::on_side) points_.push_back({side_of(corners, c.number), c.t});
        }
        parallel_sort(points_.begin(), points_.end());
        const auto same = [](const SidePoint& a, const SidePoint& b) {
            return a.side == b.side && b.t - a.t <= same_point;
        };
        points_.erase(std::unique(points_.begin(), points_.end(), same), points_.end());
    }

    void add_side_points() {
        for (const SidePoint& p : points_)
            made_.new_vertices_.push_back({{p.side.first, p.side.second, none}, {1.0 - p.t, p.t, 0.0}});
    }

    Index first_new() const { return Index(mesh_.positions.size()); }

    /// Points on a side: indices into points_.
    std::pair<Index, Index> points_on(const SideKey& side) const {
        const auto before = [](const SidePoint& p, const SideKey& s) { return p.side < s; };
        const auto after = [](const SideKey& s, const SidePoint& p) { return s < p.side; };
        return {Index(std::lower_bound(points_.begin(), points_.end(), side, before) - points_.begin()),
                Index(std::upper_bound(points_.begin(), points_.end(), side, after) - points_.begin())};
    }

    /// The vertex at a place on a side: the nearest of its points.
    Index vertex_on(const SideKey& side, double t) const {
        const auto [begin, end] = points_on(side);
        const auto nearer = [&](const SidePoint& a, const SidePoint& b) {
            return std::abs(a.t - t) < std::abs(b.t - t);
        };
        return first_new() +
               Index(std::min_element(points_.begin() + begin, points_.begin() + end, nearer) - points_.begin());
    }

    /// A corner of a polygon that is being made.
    struct Corner {
        Index vertex;
        CutMesh::Mean mean;
    };

    /// Adds a polygon with the properties of polygon f of the mesh.
    void end_polygon(std::size_t f, const std::vector<Corner>& ring) {
        for (const Corner& c : ring) {
            made_.corner_verts.push_back(int(c.vertex));
            made_.corner_means_.push_back(c.mean);
        }
        made_.polygon_offsets.push_back(int(made_.corner_verts.size()));
        if (!mesh_.material.empty()) made_.material.push_back(mesh_.material[f]);
        if (!mesh_.occluding.empty()) made_.occluding.push_back(mesh_.occluding[f]);
        if (!mesh_.one_sided.empty()) made_.one_sided.push_back(mesh_.one_sided[f]);
    }

    Corner kept(Index corner) const {
        return {Index(mesh_.corner_verts[corner]), {{corner, none, none}, {1.0, 0.0, 0.0}}};
    }

    /// Appends the points on the side between two corners of the mesh, from place t0 to t1 in the direction of the
    /// side.
    void add_between(Index from, Index to, double t0, double t1, std::vector<Corner>& ring) const {
        const Index a = mesh_.corner_verts[from], b = mesh_.corner_verts[to];
        const auto [begin, end] = points_on(std::minmax(a, b));
        std::vector<Index> between;
        for (Index i = begin; i < end; ++i)
            if (points_[i].t > std::min(t0, t1) + same_point && points_[i].t < std::max(t0, t1) - same_point)
                between.push_back(i);
        if (t0 > t1) std::reverse(between.begin(), between.end());
        for (const Index i : between) ring.push_back(on_side(from, to, first_new() + i, points_[i].t));
    }

    Corner on_side(Index from, Index to, Index vertex, double t) const {
        const double share = mesh_.corner_verts[from] < mesh_.corner_verts[to] ? t : 1.0 - t;  // of the way to `to`
        return {vertex, {{from, to, none}, {1.0 - share, share, 0.0}}};
    }

    void add_polygon(std::size_t f) {
        const ClippedPolygon& polygon = clipped_.polygons[f];
        if (polygon.what == Clipped::nothing) return;
        if (polygon.what == Clipped::whole) {
            const Index begin = mesh_.polygon_offsets[f], end = mesh_.polygon_offsets[f + 1];
            std::vector<Corner> ring;
            for (Index c = begin; c < end; ++c) {
                ring.push_back(kept(c));
                add_side(c, c + 1 < end ? c + 1 : begin, ring);
            }
            const bool divided = ring.size() > end - begin;
            if (!divided && end - begin > 4) keep_triangles(f);
            divided_.push_back(divided);
            return end_polygon(f, ring);
        }
        for (const auto& [corners, clipped] : polygon.triangles) {
            if (clipped.what == Clipped::whole) {
                std::vector<Corner> ring;
                for (int k = 0; k < 3; ++k) {
                    ring.push_back(kept(corners[k]));
                    add_side(corners[k], corners[(k + 1) % 3], ring);
                }
                divided_.push_back(true);
                end_polygon(f, ring);
            }
            for (const auto& piece : clipped.pieces) add_piece(f, corners, piece);
        }
    }

    void add_side(Index from, Index to, std::vector<Corner>& ring) const {
        const bool up = mesh_.corner_verts[from] < mesh_.corner_verts[to];
        add_between(from, to, up ? 0.0 : 1.0, up ? 1.0 : 0.0, ring);
    }

    /// Place on side `k` of a triangle; NaN elsewhere.
    double place_on(const Corners& corners, Index k, const PieceCorner& c) const {
        if (c.kind == PieceCorner::on_side) return c.number == k ? c.t : NAN;
        if (c.kind != PieceCorner::at_corner || (c.number != k && c.number != (k + 1) % 3)) return NAN;
        return Index(mesh_.corner_verts[corners[c.number]]) == side_of(corners, k).first ? 0.0 : 1.0;
    }

    void add_piece(std::size_t f, const Corners& corners, const std::vector<PieceCorner>& piece) {
        const std::optional<Outlines>& clipping = clipped_.outlines[options_.cut_of_polygon[f]];
        if (!clipping) return;
        const Outlines& outlines = *clipping;
        const Cut& cut = cuts_[options_.cut_of_polygon[f]];
        const std::array<dvec2, 3> place = {dvec2(outlines.point(cut.uvs[corners[0]])),
                                            dvec2(outlines.point(cut.uvs[corners[1]])),
                                            dvec2(outlines.point(cut.uvs[corners[2]]))};
        const double area = cross(place[1] - place[0], place[2] - place[0]);
        std::map<Index, Index> inside;  // points of outlines, which a seam meets twice
        std::vector<Corner> ring;
        for (std::size_t i = 0; i < piece.size(); ++i) {
            const PieceCorner &here = piece[i], &next = piece[(i + 1) % piece.size()];
            if (here.kind == PieceCorner::at_corner) {
                ring.push_back(kept(corners[here.number]));
            } else if (here.kind == PieceCorner::on_side) {
                const Index from = corners[here.number], to = corners[(here.number + 1) % 3];
                ring.push_back(on_side(from, to, vertex_on(side_of(corners, here.number), here.t), here.t));
            } else {
                const dvec2 at = here.place - place[0];
                const double v = cross(at, place[2] - place[0]) / area, w = cross(place[1] - place[0], at) / area;
                const CutMesh::Mean mean{corners, {1.0 - v - w, v, w}};
                const auto [known, is_new] =
                    inside.try_emplace(here.number, first_new() + Index(made_.new_vertices_.size()));
                if (is_new) {
                    made_.new_vertices_.push_back(mean);
                    for (Index& of : made_.new_vertices_.back().of) of = Index(mesh_.corner_verts[of]);
                }
                ring.push_back({known->second, mean});
            }
            for (Index k = 0; k < 3; ++k) {
                const double t0 = place_on(corners, k, here), t1 = place_on(corners, k, next);
                if (t0 == t0 && t1 == t1) add_between(corners[k], corners[(k + 1) % 3], t0, t1, ring);
            }
        }
        const auto same = [](const Corner& a, const Corner& b) { return a.vertex == b.vertex; };
        ring.erase(std::unique(ring.begin(), ring.end(), same), ring.end());
        divided_.push_back(true);
        end_polygon(f, ring);
    }

    void keep_triangles(std::size_t f) {
        const auto range = std::equal_range(mesh_.ngon_polygon.begin(), mesh_.ngon_polygon.end(), int(f));
        for (auto t = range.first; t != range.second; ++t) {
            made_.ngon_triangles.push_back(mesh_.ngon_triangles[t - mesh_.ngon_polygon.begin()]);
            made_.ngon_polygon.push_back(int(made_.polygon_offsets.size()) - 1);
        }
    }

    /// Edges of the new polygons; those along an edge of the mesh have its marks. Loose edges stay.
    void add_edges() {
        PolygonEdges edges = polygon_edges(made_.polygon_offsets, made_.corner_verts);
        made_.edge_verts.assign(edges.edge_verts.begin(), edges.edge_verts.end());
        made_.corner_edges.assign(edges.corner_edges.begin(), edges.corner_edges.end());
        std::unordered_map<std::uint64_t, Index> known;
        known.reserve(mesh_.edge_verts.size());
        const auto key = [](Index a, Index b) { return std::uint64_t(std::min(a, b)) << 32 | std::max(a, b); };
        for (Index e = 0; e < mesh_.edge_verts.size(); ++e)
            known[key(mesh_.edge_verts[e].x, mesh_.edge_verts[e].y)] = e;
        std::vector<Index> source;
        for (const glm::ivec2& e : made_.edge_verts) {
            const auto found = known.find(side_under(e, key));
            source.push_back(found == known.end() ? none : found->second);
        }
        std::vector<std::uint8_t> used(mesh_.edge_verts.size(), 0);
        for (const int e : mesh_.corner_edges) used[e] = 1;
        for (Index e = 0; e < used.size(); ++e)
            if (!used[e]) {
                made_.edge_verts.push_back(mesh_.edge_verts[e]);
                source.push_back(e);
            }
        const auto mark = [&](In<std::uint8_t> from, std::vector<std::uint8_t>& to) {
            for (const Index e : source)
                if (!from.empty()) to.push_back(e != none && from[e]);
        };
        mark(mesh_.sharp, made_.sharp);
        mark(mesh_.seam, made_.seam);
        mark(mesh_.edge_mark, made_.edge_mark);
        mark(mesh_.smooth, made_.smooth);
    }

    /// Key of the side of the mesh that an edge lies on; of none for others.
    template <typename Key>
    std::uint64_t side_under(const glm::ivec2& edge, const Key& key) const {
        const auto side = [&](Index vertex) {
            const Index number = vertex - first_new();
            return vertex >= first_new() && number < points_.size() ? points_[number].side : SideKey(vertex, vertex);
        };
        const SideKey a = side(edge.x), b = side(edge.y);
        const bool a_end = a.first == a.second, b_end = b.first == b.second;
        if (a_end && b_end) return key(a.first, b.first);
        const SideKey on = a_end ? b : a;
        const auto touches = [&](const SideKey& s, bool end) {
            return end ? s.first == on.first || s.first == on.second : s == on;
        };
        return touches(a, a_end) && touches(b, b_end) ? key(on.first, on.second) : ~std::uint64_t(0);
    }

    /// Triangulates the polygons that are new. When vertices move, pieces keep the shape that they have in their
    /// triangle.
    void triangulate();

    CutMesh& made_;
    const MeshArrays& mesh_;
    const std::vector<Cut>& cuts_;
    const CutOptions& options_;
    const ClippedMesh clipped_;
    std::vector<SidePoint> points_;
    std::vector<std::uint8_t> divided_;  // per new polygon: it needs a triangulation
};

void Builder::triangulate() {
    const std::size_t count = divided_.size();
    std::vector<std::vector<Triangle>> cut(count);
    parallel_for(count, 16, [&](std::size_t f) {
        const Index begin = made_.polygon_offsets[f], end = made_.polygon_offsets[f + 1];
        if (!divided_[f] || end - begin <= 4) return;
        std::vector<vec3> ring;
        for (Index c = begin; c < end; ++c) ring.push_back(made_.positions[made_.corner_verts[c]]);
        cut[f] = cut_ears(ring);
    });
    std::vector<glm::ivec3> triangles;
    std::vector<int> polygons;
    std::size_t next = 0;
    for (std::size_t f = 0; f < count; ++f) {
        for (; next < made_.ngon_polygon.size() && made_.ngon_polygon[next] == int(f); ++next) {
            triangles.push_back(made_.ngon_triangles[next]);
            polygons.push_back(int(f));
        }
        const int* verts = made_.corner_verts.data() + made_.polygon_offsets[f];
        for (const Triangle& t : cut[f]) {
            triangles.push_back({verts[t.x], verts[t.y], verts[t.z]});
            polygons.push_back(int(f));
        }
    }
    made_.ngon_triangles = std::move(triangles);
    made_.ngon_polygon = std::move(polygons);
}

void CutMesh::build(const MeshArrays& mesh, const std::vector<Cut>& cuts, const CutOptions& options) {
    Builder(*this, mesh, cuts, options).build();
}

}  // namespace fovea::cutout
