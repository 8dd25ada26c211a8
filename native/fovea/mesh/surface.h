// SPDX-License-Identifier: GPL-3.0-or-later
// A surface: Blender's polygons with their edge table, triangles for ray casting, and facets for facing tests.
#pragma once

#include <memory>
#include <string>

#include <fovea/base/cache.h>
#include <fovea/base/types.h>
#include <fovea/mesh/field_options.h>
#include <fovea/mesh/height_jet.h>
#include <fovea/mesh/shape.h>

namespace fovea::mesh {

using Triangle = glm::uvec3;
using Edge = glm::uvec2;

/// Index, 0 to 2, of a triangle's corner at a vertex of it.
inline int corner_of(const Triangle& t, Index vertex) { return t.x == vertex ? 0 : t.y == vertex ? 1 : 2; }

/// Normal of a triangle, twice as long as its area is large.
inline dvec3 area_vector(In<vec3> positions, const Triangle& triangle) {
    const dvec3 p(positions[triangle.x]);
    return glm::cross(dvec3(positions[triangle.y]) - p, dvec3(positions[triangle.z]) - p);
}

/// Mesh arrays as Blender stores them. Optional arrays may be empty.
template <template <typename> typename ArrayOf>
struct MeshOf {
    ArrayOf<vec3> positions;         ///< per vertex, object space
    ArrayOf<glm::ivec2> edge_verts;  ///< per edge
    ArrayOf<int> corner_verts;       ///< per corner
    ArrayOf<int> corner_edges;       ///< per corner: the edge to the polygon's next corner
    ArrayOf<int> polygon_offsets;    ///< polygons + 1: corners of polygon f are [f] .. [f + 1]
    /// Vertices; triangulation of polygons with more than 4 corners, ordered by polygon.
    ArrayOf<glm::ivec3> ngon_triangles;
    ArrayOf<int> ngon_polygon;                     ///< per ngon triangle: its polygon, ascending
    ArrayOf<int> material;                         ///< optional, per polygon
    ArrayOf<std::uint8_t> occluding;               ///< optional, per polygon: 0 where the material does not occlude
    ArrayOf<std::uint8_t> sharp, seam, edge_mark;  ///< optional, per edge
    ArrayOf<std::uint8_t> smooth;                  ///< optional, per edge: shading is continuous across it
    ArrayOf<std::uint8_t> one_sided;               ///< optional, per polygon: 1 where its back is not seen (culled)
};

/// Mesh whose arrays are borrowed.
using MeshArrays = MeshOf<In>;

template <typename T>
using Owned = std::vector<T>;

/// Mesh that owns its arrays.
struct OwnedMesh : MeshOf<Owned> {
    MeshArrays arrays() const {
        return {positions, edge_verts, corner_verts, corner_edges, polygon_offsets, ngon_triangles, ngon_polygon,
                material,  occluding,  sharp,        seam,         edge_mark,       smooth,         one_sided};
    }
};

/// Ends a message about arrays of a mesh that contradict each other.
inline constexpr const char* mesh_is_broken = "; the mesh is broken (Mesh > Validate mends it)";

/// Throws std::invalid_argument, naming the object, when array sizes or indices do not fit together.
void check_mesh(const std::string& name, const MeshArrays& mesh);

/// The triangles that a mesh comes with for polygons of more than four corners. A polygon of which one names a vertex
/// that is none of its corners has none.
class NgonTriangles {
   public:
    NgonTriangles() = default;
    explicit NgonTriangles(const MeshArrays& mesh);
    /// Vertices, in the mesh's order.
    In<Triangle> of(std::size_t polygon) const { return lists_.count() ? lists_[Index(polygon)] : In<Triangle>(); }

   private:
    Lists<Triangle> lists_;  // no rows where no polygon has any
};

/// Bits of edge marks.
enum Mark : std::uint8_t { mark_sharp = 1, mark_seam = 2, mark_edge = 4, mark_smooth = 8 };

/// Elements that were skipped or look wrong; counts.
struct SurfaceReport {
    Index non_finite_vertices = 0;  ///< NaN or infinite positions
    Index degenerate_polygons = 0;  ///< fewer than 3 distinct corners, no area, or a broken vertex
    Index duplicate_polygons = 0;   ///< the same vertices as an earlier polygon
    Index loose_edges = 0;          ///< edges without a polygon: the last mesh edges
    Index non_manifold_edges = 0;   ///< more than two polygons; all are kept
    Index inconsistent_edges = 0;   ///< two adjacent polygons of opposite orientation; kept
};

/// An incident facet of an edge. `forward`: the facet's boundary runs from the edge's first vertex to its second. Of a
/// consistently oriented pair, one is forward and the other is not.
struct EdgeSide {
    Index packed;
    EdgeSide() = default;
    EdgeSide(Index facet, bool forward) : packed(facet << 1 | Index(forward)) {}
    Index facet() const { return packed >> 1; }
    bool forward() const { return packed & 1; }
};

/// Arrays of a surface.
struct SurfaceArrays {
    // Topology. Skipped polygons keep their index but have no facets.
    Array<Edge> edges;               ///< mesh edges as the corners first name them, then diagonals of bent polygons
    Index mesh_edges = 0;            ///< number of `edges` that are mesh edges
    Array<std::uint8_t> edge_marks;  ///< per mesh edge: Mark bits
    Array<int> polygon_material;     ///< per polygon
    Array<std::uint8_t> polygon_one_sided;  ///< per polygon: its back is not seen; empty: all backs are

    // Geometry.
    Array<vec3> positions;      ///< object space; one spare entry at the end (Embree reads 16 bytes)
    Array<Triangle> triangles;  ///< vertices; occluding triangles first, of these the two-sided ones
    Array<Index> triangle_facet;
    Index occluding_triangles = 0;  ///< number of `triangles` that occlude
    Index two_sided_triangles = 0;  ///< number of those whose backs occlude, too
    Array<vec4> facet_plane;        ///< unit normal n and offset d with n.x = d; outward by winding
    Array<Index> facet_polygon;
    Rows edge_rows;  ///< per entry of `edges`: its range of edge_sides
    Array<EdgeSide> edge_sides;
    vec3 center{0.0f}, half{0.0f};  ///< of the bounding box: its center, and half its sides
    float radius = 0.0f;            ///< of a sphere at `center` that contains all vertices
};

/// A facet is the largest piece that is planar: a whole polygon if it is (to 0.1 degrees), else each of its triangles
/// with the slivers beside it (mesh/slivers.h). Facing, contours and creases are evaluated on facets, so the diagonal
/// of a planar polygon is never a candidate, while a diagonal of a non-planar one can be a contour.
class Surface : public SurfaceArrays {
   public:
    /// Throws std::invalid_argument, naming the object, when array sizes or indices do not fit together.
    Surface(std::string name, const MeshArrays& mesh);

    /// `source` with its vertices moved by a linear map (see mesh/stretch.h). For reading only: the corner tables
    /// (polygon_vertices, corner_count) are not copied, so set_positions must not be called. Must not outlive the
    /// source.
    Surface(const Surface& source, const dmat3& stretch);

    /// Moves the vertices; topology is unchanged. Clears everything derived from positions. With `refit`, lasting_cache
    /// is kept and updated, not rebuilt: faster, and rays tell the same to the last bit.
    void set_positions(In<vec3> positions, bool refit = false);

    /// Sets where the vertices are in the rest shape, before what deforms the surface; none: where they are. Throws
    /// std::invalid_argument, naming the object, for another number of them.
    void set_rest(In<vec3> positions);
    /// Per vertex, object space; empty: `positions`. A stretched surface has none.
    In<vec3> rest() const { return rest_; }

    /// Sets how fields are estimated; fields are cached per options. Throws std::invalid_argument, naming the object,
    /// for options out of range.
    void set_field_options(const FieldOptions& options);
    const FieldOptions& field_options() const { return source_ ? source_->field_options() : field_options_; }

    /// How an artist wants the surface to be drawn, or what its rest shape says; see field/shape.h.
    void set_shape(Shape shape) { shape_ = shape; }
    Shape shape() const { return source_ ? source_->shape() : shape_; }

    const std::string& name() const { return name_; }
    /// The surface that this one was stretched from, and the map; null and the identity for an ordinary mesh.
    const Surface* source() const { return source_; }
    const dmat3& stretch() const { return stretch_; }
    const SurfaceReport& report() const { return report_; }

    /// Per vertex: jet of the smooth (limit) surface that the vertices lie on; empty where there is none.
    Array<HeightJet> jets;

    Index vertex_count() const { return static_cast<Index>(positions.size()) - 1; }
    In<EdgeSide> sides(Index edge) const { return {edge_sides.data() + edge_rows.begin(edge), edge_rows.size(edge)}; }
    int material(Index facet) const { return polygon_material[facet_polygon[facet]]; }

    /// Whether a facet is not seen, since it turns its back to the eye and its polygon is one-sided. `eye_obj`:
    /// homogeneous; for an orthographic view the direction towards the viewer.
    bool culled(Index facet, const dvec4& eye_obj) const {
        if (polygon_one_sided.empty() || !polygon_one_sided[facet_polygon[facet]]) return false;
        const vec4& p = facet_plane[facet];
        return glm::dot(dvec4(p.x, p.y, p.z, -p.w), eye_obj) < 0.0;
    }

    /// Element that supports a line segment: an edge, by its index, or a triangle, numbered after the edges.
    Index place_of_triangle(Index triangle) const { return static_cast<Index>(edges.size()) + triangle; }
    bool is_edge(Index place) const { return place < edges.size(); }
    /// Whether an edge belongs to no polygon.
    bool is_loose(Index edge) const { return edge < mesh_edges && edge >= mesh_edges - report_.loose_edges; }
    Index triangle_at(Index place) const { return place - static_cast<Index>(edges.size()); }
    Index place_count() const { return static_cast<Index>(edges.size() + triangles.size()); }

    /// Vertices at a polygon's corners, in mesh order; and the mesh corner index of the first of them.
    In<Index> polygon_vertices(Index polygon) const {
        return {corner_verts_.data() + polygons_.begin(polygon), polygons_.size(polygon)};
    }
    Index first_corner(Index polygon) const { return polygons_.begin(polygon); }
    Index corner_count() const { return static_cast<Index>(corner_verts_.size()); }

    Index polygon_count() const { return polygons_.count(); }
    Index facet_count() const { return static_cast<Index>(facet_plane.size()); }

    /// Quantities that later stages derive from this surface (BVH, view-independent lines, chains); cleared when it
    /// moves.
    Cache& cache() const { return *cache_; }
    /// Entries that are updated in place when the vertices move with `refit`.
    Cache& lasting_cache() const { return *lasting_cache_; }
    /// Changes whenever the positions do; a stretched surface has that of its source.
    std::uint64_t version() const { return version_; }

   private:
    void take_topology(const MeshArrays& mesh);
    void build_edge_corners();
    void build_geometry();
    /// Newell's normal (twice the area vector) and the perimeter of a polygon; exact for planar polygons, a mean
    /// otherwise.
    struct Outline {
        dvec3 area;
        double perimeter;
    };
    Outline outline_of(In<Index> corners) const;
    bool is_flat(In<Index> corners, const Outline& outline) const;
    /// Also returns the outlines of all others; those of polygons that it skips are not set.
    Array<Outline> find_degenerate(Array<std::uint8_t>& skip);
    void find_duplicates(Array<std::uint8_t>& skip);
    void triangulate(const Array<std::uint8_t>& skip);
    void build_facets(const Array<std::uint8_t>& skip, const Array<Outline>& outlines);
    void build_edge_sides(const Array<std::uint8_t>& skip);
    void sort_occluding();
    void bound();

    /// A diagonal of a non-planar polygon, with the facets on its two sides.
    struct Diagonal {
        Edge edge;
        EdgeSide first, second;
    };
    /// A side of a triangle (`facet` set) or of the polygon itself (`corner` set), vertices ascending.
    struct TriangleSide {
        Index low, high;
        bool ascending;
        Index facet, corner;
    };
    /// Tells which facet is at each corner's side of a polygon of several, and adds its diagonals between them.
    void split_bent_polygon(Index polygon, std::vector<TriangleSide>& scratch, Array<Index>& corner_facet,
                            Array<Diagonal>& diagonals) const;
    void split_bent_quad(Index quad, Array<Index>& corner_facet, Array<Diagonal>& diagonals) const;

    std::string name_;
    Rows polygons_;  // corners of polygons
    Array<Index> corner_verts_;
    Array<Index> corner_edges_;  // per corner; none where the mesh names an edge between other vertices
    Lists<Index> edge_corners_;  // corners whose side runs along each mesh edge; empty until the surface moves
    NgonTriangles ngon_triangles_;
    Array<std::uint8_t> polygon_occludes_;
    Rows polygon_triangles_;
    SurfaceReport report_;
    FieldOptions field_options_;
    Shape shape_ = Shape::automatic;
    Array<vec3> rest_;
    const Surface* source_ = nullptr;
    dmat3 stretch_{1.0};
    std::unique_ptr<Cache> cache_ = std::make_unique<Cache>(), lasting_cache_ = std::make_unique<Cache>();
    std::uint64_t version_ = 0;
};

}  // namespace fovea::mesh
