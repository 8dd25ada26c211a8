// SPDX-License-Identifier: GPL-3.0-or-later
// A surface: Blender's polygons with their own edge table, triangles for rays, and facets for facing.
#pragma once

#include <memory>
#include <string>

#include <fovea/base/cache.h>
#include <fovea/base/types.h>
#include <fovea/mesh/field_options.h>
#include <fovea/mesh/height_jet.h>

namespace fovea::mesh {

using Triangle = glm::uvec3;
using Edge = glm::uvec2;

/// Which corner of a triangle a vertex is.
inline int corner_of(const Triangle& t, Index vertex) { return t.x == vertex ? 0 : t.y == vertex ? 1 : 2; }

/// A mesh as Blender holds it. Optional arrays may be empty.
template <template <typename> typename ArrayOf>
struct MeshOf {
    ArrayOf<vec3> positions;             ///< per vertex, object space
    ArrayOf<glm::ivec2> edge_verts;      ///< per edge
    ArrayOf<int> corner_verts;           ///< per corner
    ArrayOf<int> corner_edges;           ///< per corner: the edge to the polygon's next corner
    ArrayOf<int> polygon_offsets;        ///< polygons + 1: corners of polygon f
    ArrayOf<glm::ivec3> ngon_triangles;  ///< vertices; triangulation of polygons with more than 4 corners, by polygon
    ArrayOf<int> ngon_polygon;           ///< per ngon triangle: its polygon, ascending
    ArrayOf<int> material;               ///< optional, per polygon
    ArrayOf<std::uint8_t> occluding;     ///< optional, per polygon: 0 where the material lets lines behind it show
    ArrayOf<std::uint8_t> sharp, seam, edge_mark;  ///< optional, per edge
};

/// Borrowed.
using MeshArrays = MeshOf<In>;

template <typename T>
using Owned = std::vector<T>;

/// One that owns its arrays.
struct OwnedMesh : MeshOf<Owned> {
    MeshArrays arrays() const {
        return {positions, edge_verts, corner_verts, corner_edges, polygon_offsets, ngon_triangles, ngon_polygon,
                material,  occluding,  sharp,        seam,         edge_mark};
    }
};

/// Throws std::invalid_argument, naming the object, when array sizes or indices do not fit together.
void check_mesh(const std::string& name, const MeshArrays& mesh);

/// Marks of an edge.
enum Mark : std::uint8_t { mark_sharp = 1, mark_seam = 2, mark_edge = 4 };

/// What was skipped or looked wrong when a surface was built; counts of elements.
struct SurfaceReport {
    Index non_finite_vertices = 0;  ///< NaN or infinite positions
    Index degenerate_polygons = 0;  ///< fewer than 3 distinct corners, no area, or a broken vertex
    Index duplicate_polygons = 0;   ///< the same vertices as an earlier polygon
    Index loose_edges = 0;          ///< edges without a polygon: they bound no surface and draw no line
    Index non_manifold_edges = 0;   ///< more than two polygons; kept, all of them
    Index inconsistent_edges = 0;   ///< neighbors that disagree about which side is out; kept
};

/// One incident facet of an edge, and whether the facet's boundary runs along the edge from its first to its second
/// vertex (`forward`). Of a consistently oriented pair one is forward and the other is not.
struct EdgeSide {
    Index packed;
    EdgeSide() = default;
    EdgeSide(Index facet, bool forward) : packed(facet << 1 | Index(forward)) {}
    Index facet() const { return packed >> 1; }
    bool forward() const { return packed & 1; }
};

/// What a surface consists of.
struct SurfaceArrays {
    // Topology, as given. Polygons that were skipped keep their number and have no facets.
    Array<Edge> edges;               ///< mesh edges, then the diagonals of bent polygons
    Index mesh_edges = 0;            ///< how many of `edges` are the mesh's own
    Array<std::uint8_t> edge_marks;  ///< per mesh edge: Mark bits
    Array<int> polygon_material;     ///< per polygon

    // Geometry.
    Array<vec3> positions;      ///< object space; one spare entry at the end (Embree reads 16 bytes)
    Array<Triangle> triangles;  ///< vertices; occluding ones first
    Array<Index> triangle_facet;
    Index occluding_triangles = 0;  ///< how many of `triangles` hide what lies behind
    Array<vec4> facet_plane;        ///< unit normal n and offset d: n.x = d; outward by winding
    Array<Index> facet_polygon;
    Rows edge_rows;  ///< per entry of `edges`: its sides
    Array<EdgeSide> edge_sides;
    vec3 center{0.0f};    ///< of the bounding box
    float radius = 0.0f;  ///< of the sphere around it that holds all vertices
};

/// A facet is the largest piece known to be flat: a whole polygon when it is planar (to 0.1 degrees), else each of its
/// triangles. Facing, contours and creases are asked of facets, so a diagonal of a flat polygon is never a candidate,
/// and a diagonal of a bent one can be a contour.
class Surface : public SurfaceArrays {
   public:
    /// Throws std::invalid_argument, naming the object, when array sizes or indices do not fit together.
    Surface(std::string name, const MeshArrays& mesh);

    /// `source` with its vertices moved by a linear map (see mesh/stretch.h), for reading alone: its topology cannot be
    /// told from the source's, and it must not outlive it.
    Surface(const Surface& source, const dmat3& stretch);

    /// Moves the vertices; topology stays. Everything derived from positions is dropped; with `refit`, what is in
    /// `lasting_cache` stays and follows. That is faster, but what it tells differs in the last bits from what a new
    /// surface there would tell, so it depends on where the vertices were before.
    void set_positions(In<vec3> positions, bool refit = false);

    /// How fields are to be estimated; other options, other fields. Throws std::invalid_argument, naming the object,
    /// for options out of range.
    void set_field_options(const FieldOptions& options);
    const FieldOptions& field_options() const { return source_ ? source_->field_options() : field_options_; }

    const std::string& name() const { return name_; }
    /// What this was stretched from, and how; null and the identity for a mesh as it is.
    const Surface* source() const { return source_; }
    const dmat3& stretch() const { return stretch_; }
    const SurfaceReport& report() const { return report_; }

    /// Per vertex, of the smooth surface that the vertices lie on; empty where nothing but the vertices is known.
    Array<HeightJet> jets;

    Index vertex_count() const { return static_cast<Index>(positions.size()) - 1; }
    In<EdgeSide> sides(Index edge) const { return {edge_sides.data() + edge_rows.begin(edge), edge_rows.size(edge)}; }
    int material(Index facet) const { return polygon_material[facet_polygon[facet]]; }

    /// Where a line can lie: on an edge, by its number, or in a triangle, numbered after the edges.
    Index place_of_triangle(Index triangle) const { return static_cast<Index>(edges.size()) + triangle; }
    bool is_edge(Index place) const { return place < edges.size(); }
    Index triangle_at(Index place) const { return place - static_cast<Index>(edges.size()); }
    Index place_count() const { return static_cast<Index>(edges.size() + triangles.size()); }

    /// Vertices at a polygon's corners in the mesh's order, and which of the mesh's corners is the first of them.
    In<Index> polygon_vertices(Index polygon) const {
        return {corner_verts_.data() + polygons_.begin(polygon), polygons_.size(polygon)};
    }
    Index first_corner(Index polygon) const { return polygons_.begin(polygon); }
    Index corner_count() const { return static_cast<Index>(corner_verts_.size()); }

    Index polygon_count() const { return polygons_.count(); }
    Index facet_count() const { return static_cast<Index>(facet_plane.size()); }

    /// What later stages derive from this surface (BVH, static lines, chains).
    Cache& cache() const { return *cache_; }
    /// What is brought up to date when the vertices move with `refit`, instead of being derived anew.
    Cache& lasting_cache() const { return *lasting_cache_; }
    /// Changes whenever the positions do.
    std::uint64_t version() const { return version_; }

   private:
    void take_topology(const MeshArrays& mesh);
    void build_edge_corners();
    void build_geometry();
    void find_degenerate(Array<std::uint8_t>& skip);
    void find_duplicates(Array<std::uint8_t>& skip);
    void triangulate(const Array<std::uint8_t>& skip);
    void build_facets(const Array<std::uint8_t>& skip);
    void build_edge_sides(const Array<std::uint8_t>& skip);
    void sort_occluding();
    void bound();

    /// A diagonal of a bent polygon with the triangles on both sides.
    struct Diagonal {
        Edge edge;
        EdgeSide first, second;
    };
    /// A side of a triangle (facet set) or of the polygon itself (corner set), by ascending vertices.
    struct TriangleSide {
        Index low, high;
        bool ascending;
        Index facet, corner;
    };
    void split_bent_polygon(Index polygon, std::vector<TriangleSide>& scratch, std::vector<Diagonal>& diagonals);

    std::string name_;
    Rows polygons_;  // corners of polygons
    Array<Index> corner_verts_, corner_edges_;
    Lists<Index> edge_corners_;  // corners that run along each mesh edge
    Array<Triangle> ngon_triangles_;
    Rows ngon_rows_;  // per polygon: its rows of ngon_triangles_
    Array<std::uint8_t> polygon_occludes_;
    Array<Index> corner_facet_;  // facet that the side starting at each corner bounds

    Rows polygon_triangles_;
    SurfaceReport report_;
    FieldOptions field_options_;
    const Surface* source_ = nullptr;
    dmat3 stretch_{1.0};
    std::unique_ptr<Cache> cache_ = std::make_unique<Cache>(), lasting_cache_ = std::make_unique<Cache>();
    std::uint64_t version_ = 0;
};

}  // namespace fovea::mesh
