// SPDX-License-Identifier: GPL-3.0-or-later
#include <fovea/mesh/polygon_surface.h>

#include <algorithm>
#include <unordered_map>

#include <fovea/base/check.h>
#include <fovea/base/parallel.h>
#include <fovea/mesh/ears.h>

namespace fovea::mesh {
namespace {

/// Polygons with more corners are not ear-clipped, which may take quadratic time; Surface triangulates them as a fan.
constexpr int most_corners = 1 << 14;

/// Triangles of the polygons with more than four corners, and the polygon of each.
std::pair<std::vector<glm::ivec3>, std::vector<int>> ngon_triangles(In<vec3> positions, In<int> corner_verts,
                                                                    In<int> offsets) {
    std::vector<std::vector<Triangle>> cut(offsets.empty() ? 0 : offsets.size() - 1);
    const auto corners_of = [&](std::size_t f) { return offsets[f + 1] - offsets[f]; };
    parallel_for(cut.size(), 64, [&](std::size_t f) {
        if (corners_of(f) <= 4 || corners_of(f) > most_corners) return;
        std::vector<vec3> corners;
        for (int c = offsets[f]; c < offsets[f + 1]; ++c) corners.push_back(positions[corner_verts[c]]);
        cut[f] = cut_ears(corners);
    });
    std::vector<glm::ivec3> triangles;
    std::vector<int> polygons;
    for (std::size_t f = 0; f < cut.size(); ++f) {
        const int* verts = corner_verts.data() + offsets[f];
        for (const Triangle& t : cut[f]) {
            triangles.push_back({verts[t.x], verts[t.y], verts[t.z]});
            polygons.push_back(int(f));
        }
    }
    return {std::move(triangles), std::move(polygons)};
}

void check_offsets(const std::string& before, In<int> polygon_offsets, In<int> corner_verts) {
    check(polygon_offsets.empty() ||
              (polygon_offsets.front() >= 0 && std::is_sorted(polygon_offsets.begin(), polygon_offsets.end()) &&
               std::size_t(polygon_offsets.back()) <= corner_verts.size()),
          before + "polygon_offsets must ascend and stay within corner_verts" + mesh_is_broken);
}

}  // namespace

PolygonEdges polygon_edges(In<int> polygon_offsets, In<int> corner_verts) {
    check_offsets("", polygon_offsets, corner_verts);
    PolygonEdges result;
    result.corner_edges.resize(corner_verts.size());
    std::unordered_map<std::uint64_t, int> known;
    known.reserve(corner_verts.size());
    for (std::size_t f = 0; f + 1 < polygon_offsets.size(); ++f) {
        for (int c = polygon_offsets[f]; c < polygon_offsets[f + 1]; ++c) {
            const int a = corner_verts[c];
            const int b = corner_verts[c + 1 < polygon_offsets[f + 1] ? c + 1 : polygon_offsets[f]];
            const auto key = std::uint64_t(std::min(a, b)) << 32 | std::uint32_t(std::max(a, b));
            const auto [it, inserted] = known.try_emplace(key, static_cast<int>(result.edge_verts.size()));
            if (inserted) result.edge_verts.push_back({a, b});
            result.corner_edges[c] = it->second;
        }
    }
    return result;
}

std::shared_ptr<Surface> polygon_surface(const std::string& name, In<vec3> positions, In<int> corner_verts,
                                         In<int> polygon_offsets, In<int> material) {
    check_offsets(name + ": ", polygon_offsets, corner_verts);
    const PolygonEdges edges = polygon_edges(polygon_offsets, corner_verts);
    MeshArrays mesh;
    mesh.positions = positions;
    mesh.edge_verts = edges.edge_verts;
    mesh.corner_verts = corner_verts;
    mesh.corner_edges = edges.corner_edges;
    mesh.polygon_offsets = polygon_offsets;
    mesh.material = material;
    check_mesh(name, mesh);
    const auto [triangles, triangle_polygons] = ngon_triangles(positions, corner_verts, polygon_offsets);
    mesh.ngon_triangles = triangles;
    mesh.ngon_polygon = triangle_polygons;
    return std::make_shared<Surface>(name, mesh);
}

}  // namespace fovea::mesh
