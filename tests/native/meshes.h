// SPDX-License-Identifier: GPL-3.0-or-later
// Small named meshes, as Blender would hold them.
#pragma once

#include <algorithm>
#include <cmath>
#include <map>
#include <memory>
#include <numbers>

#include <fovea/mesh/surface.h>

namespace fovea::meshes {
using namespace draw;

/// A mesh that owns its arrays.
struct Mesh {
    std::string name;
    std::vector<vec3> positions;
    std::vector<glm::ivec2> edge_verts;
    std::vector<int> corner_verts, corner_edges, polygon_offsets{0};
    std::vector<glm::ivec3> ngon_triangles;
    std::vector<int> ngon_polygon, material;
    std::vector<std::uint8_t> occluding, sharp, seam, edge_mark, smooth, one_sided;

    Shape shape = Shape::hard;  // coarse meshes are easily checked by all of their edges

    Mesh(std::string called, std::vector<vec3> points);

    MeshArrays arrays() const {
        return {positions, edge_verts, corner_verts, corner_edges, polygon_offsets, ngon_triangles, ngon_polygon,
                material,  occluding,  sharp,        seam,         edge_mark,       smooth,         one_sided};
    }
    std::shared_ptr<Surface> surface() const;

    /// Number of the edge between two vertices; added when there is none.
    int edge(int a, int b);

    void add_polygon(const std::vector<int>& verts);

    /// A per-edge flag array with the given edges set.
    std::vector<std::uint8_t> edge_flags(const std::vector<int>& edges) const;

   private:
    std::map<std::pair<int, int>, int> edge_of_;
};

using Polygons = std::vector<std::vector<int>>;

Mesh of_polygons(const std::string& name, const std::vector<vec3>& positions, const Polygons& polygons);

/// A mesh, and another 5 to its right, as one.
Mesh with_another(const Mesh& first, const Mesh& second);

/// Polygons of another mesh with their winding turned around where `flip(polygon)` holds.
template <typename Flip>
Mesh flipped(const Mesh& mesh, const Flip& flip) {
    Mesh result(mesh.name, mesh.positions);
    for (const glm::ivec2& e : mesh.edge_verts) result.edge(e.x, e.y);  // the same edge numbers
    for (std::size_t f = 0; f + 1 < mesh.polygon_offsets.size(); ++f) {
        std::vector<int> verts(mesh.corner_verts.begin() + mesh.polygon_offsets[f],
                               mesh.corner_verts.begin() + mesh.polygon_offsets[f + 1]);
        if (flip(static_cast<int>(f))) std::reverse(verts.begin(), verts.end());
        result.add_polygon(verts);
    }
    return result;
}

/// Vertex i has bit 0 of i in x, bit 1 in y, bit 2 in z. 6 quads, 12 edges, outward.
Mesh box(vec3 low = vec3(-1), vec3 high = vec3(1));

Mesh tetrahedron();

/// n x n squares in the plane z = 0 over [-1,1]^2, facing up; vertex i + (n + 1) j.
Mesh grid(int n, float half = 1.0f);

/// The grid with heights z(x, y), its squares split from their lower left to their upper right corners.
template <typename Height>
Mesh relief(int n, const Height& z) {
    Mesh mesh("relief", grid(n).positions);
    for (vec3& p : mesh.positions) p.z = float(z(p.x, p.y));
    for (int j = 0; j < n; ++j)
        for (int i = 0; i < n; ++i) {
            const int a = i + (n + 1) * j, b = a + 1, c = b + n + 1, d = a + n + 1;
            mesh.add_polygon({a, b, c});
            mesh.add_polygon({a, c, d});
        }
    return mesh;
}

/// Unit sphere: 2n segments around z, n rings, triangles at the poles.
Mesh sphere(int n);

/// n quads around z, radius 1, from z = -1 to 1, open at both ends.
Mesh cylinder(int n);

/// One-sided strip of n quads: exactly one edge where neighbors disagree about which side is out.
Mesh moebius(int n);

/// Two boxes that touch along one edge: four polygons meet there.
Mesh two_boxes_at_an_edge();

/// A quad with one corner lifted: two triangles that meet at its diagonal 0-2.
Mesh bent_quad(float lift = 0.5f);

/// An arrow head: the diagonal 0-2 lies outside, 1-3 inside.
Mesh concave_quad();

/// A flat L of six corners, and the triangulation that Blender would give.
Mesh l_shape();

}  // namespace fovea::meshes
