// SPDX-License-Identifier: GPL-3.0-or-later
#include <fovea/mesh/polygon_surface.h>

#include <fovea/base/parallel.h>
#include <fovea/mesh/ears.h>
#include <fovea/mesh/polygon_edges.h>

namespace fovea {
namespace {

/// Larger polygons are left to be cut as a fan: cutting ears takes time with the square of their corners.
constexpr int most_corners = 1 << 14;

struct NgonTriangles {
    std::vector<glm::ivec3> vertices;
    std::vector<int> polygon;
};

/// Triangles of the polygons with more than four corners.
NgonTriangles ngon_triangles(In<vec3> positions, In<int> corner_verts, In<int> offsets) {
    std::vector<std::vector<Triangle>> cut(offsets.empty() ? 0 : offsets.size() - 1);
    const auto corners_of = [&](std::size_t f) { return offsets[f + 1] - offsets[f]; };
    parallel_for(
        cut.size(),
        [&](std::size_t f) {
            if (corners_of(f) <= 4 || corners_of(f) > most_corners) return;
            std::vector<vec3> corners;
            for (int c = offsets[f]; c < offsets[f + 1]; ++c) corners.push_back(positions[corner_verts[c]]);
            cut[f] = cut_ears(corners);
        },
        64);
    NgonTriangles all;
    for (std::size_t f = 0; f < cut.size(); ++f) {
        const int* verts = corner_verts.data() + offsets[f];
        for (const Triangle& t : cut[f]) {
            all.vertices.push_back({verts[t.x], verts[t.y], verts[t.z]});
            all.polygon.push_back(int(f));
        }
    }
    return all;
}

}  // namespace

std::shared_ptr<Surface> polygon_surface(const std::string& name, In<vec3> positions, In<int> corner_verts,
                                         In<int> polygon_offsets, In<int> material) {
    const PolygonEdges edges = polygon_edges(polygon_offsets, corner_verts);
    const NgonTriangles ngons = ngon_triangles(positions, corner_verts, polygon_offsets);
    MeshArrays mesh;
    mesh.positions = positions;
    mesh.edge_verts = edges.edge_verts;
    mesh.corner_verts = corner_verts;
    mesh.corner_edges = edges.corner_edges;
    mesh.polygon_offsets = polygon_offsets;
    mesh.ngon_triangles = ngons.vertices;
    mesh.ngon_polygon = ngons.polygon;
    mesh.material = material;
    return std::make_shared<Surface>(name, mesh);
}

}  // namespace fovea
