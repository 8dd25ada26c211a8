// SPDX-License-Identifier: GPL-3.0-or-later
// Topology of a surface: validation, edge table, marks. Geometry is in surface_geometry.cpp.
#include <fovea/mesh/surface.h>

#include <algorithm>
#include <atomic>
#include <cmath>

#include <fovea/base/check.h>
#include <fovea/base/parallel.h>

namespace fovea::mesh {
namespace {

std::uint64_t next_version() {
    static std::atomic<std::uint64_t> counter{0};
    return ++counter;
}

template <typename T>
void check_size(In<T> values, std::size_t size, const std::string& name, const char* what) {
    check(values.empty() || values.size() == size, name + ": " + what + " has " + std::to_string(values.size()) +
                                                       " entries, expected " + std::to_string(size) + mesh_is_broken);
}

/// Checks that every value is in [0, limit).
void check_range(In<int> values, std::size_t limit, const std::string& name, const char* what) {
    std::atomic<bool> fits{true};
    parallel_blocks(values.size(), 1 << 16, [&](std::size_t, std::size_t begin, std::size_t end) {
        int low = 0, high = -1;
        for (std::size_t i = begin; i < end; ++i) {
            low = std::min(low, values[i]);
            high = std::max(high, values[i]);
        }
        if (low < 0 || high >= static_cast<std::int64_t>(limit)) fits = false;
    });
    check(fits, name + ": " + what + " names an element that does not exist" + mesh_is_broken);
}

template <int N>
In<int> flat(In<glm::vec<N, int>> values) {
    return {reinterpret_cast<const int*>(values.data()), values.size() * N};
}

/// Per corner of a mesh, the edge to the polygon's next corner; none where the edge that is named joins other vertices.
Array<Index> corner_edges_of(const MeshArrays& mesh) {
    auto edges = parallel_filled(mesh.corner_verts.size(), none);
    parallel_for(mesh.polygon_offsets.empty() ? 0 : mesh.polygon_offsets.size() - 1, [&](std::size_t f) {
        const int begin = mesh.polygon_offsets[f], end = mesh.polygon_offsets[f + 1];
        for (int c = begin; c < end; ++c) {
            const int edge = mesh.corner_edges[c], a = mesh.corner_verts[c];
            const int b = mesh.corner_verts[c + 1 < end ? c + 1 : begin];
            const glm::ivec2 ends = mesh.edge_verts[edge];
            if ((ends.x == a && ends.y == b) || (ends.x == b && ends.y == a)) edges[c] = Index(edge);
        }
    });
    return edges;
}

/// Per edge of a mesh, its number in the order in which the polygons have them, of each polygon first the one that ends
/// at its first corner; edges without a polygon come last. Blender numbers the edges that it makes in this order on one
/// core, and in others on more: lines would begin elsewhere on another machine.
Array<Index> edge_numbers(const MeshArrays& mesh, In<Index> corner_edges) {
    auto number = parallel_filled(mesh.edge_verts.size(), none);
    Index next = 0;
    const auto give = [&](int corner) {
        if (corner_edges[corner] == none) return;
        if (Index& of = number[corner_edges[corner]]; of == none) of = next++;
    };
    for (std::size_t f = 1; f < mesh.polygon_offsets.size(); ++f) {
        const int begin = mesh.polygon_offsets[f - 1], end = mesh.polygon_offsets[f];
        if (begin < end) give(end - 1);
        for (int corner = begin; corner + 1 < end; ++corner) give(corner);
    }
    for (Index& of : number)
        if (of == none) of = next++;
    return number;
}

}  // namespace

NgonTriangles::NgonTriangles(const MeshArrays& mesh) {
    if (mesh.ngon_polygon.empty()) return;
    const std::size_t polygons = mesh.polygon_offsets.size() - 1;
    Array<std::uint8_t> refused(polygons, 0);
    std::vector<int> corners;
    for (std::size_t t = 0; t < mesh.ngon_polygon.size(); ++t) {
        const int f = mesh.ngon_polygon[t];
        if (t == 0 || f != mesh.ngon_polygon[t - 1]) {
            const auto all = mesh.corner_verts.begin();
            corners.assign(all + mesh.polygon_offsets[f], all + mesh.polygon_offsets[f + 1]);
            std::ranges::sort(corners);
            refused[f] = corners.size() <= 4;
        }
        for (int i = 0; i < 3; ++i) refused[f] |= !std::ranges::binary_search(corners, mesh.ngon_triangles[t][i]);
    }
    lists_ = lists_of<Triangle>(polygons, [&](const auto& give) {
        for (std::size_t t = 0; t < mesh.ngon_polygon.size(); ++t)
            if (!refused[mesh.ngon_polygon[t]]) give(mesh.ngon_polygon[t], Triangle(mesh.ngon_triangles[t]));
    });
}

void check_mesh(const std::string& name, const MeshArrays& mesh) {
    const std::size_t corners = mesh.corner_verts.size(), edge_count = mesh.edge_verts.size();
    const std::size_t polygon_total = mesh.polygon_offsets.empty() ? 0 : mesh.polygon_offsets.size() - 1;
    check(mesh.positions.size() < none / 4 && corners < none / 4,
          name + ": more than a billion elements; split it into several objects");
    check(mesh.corner_edges.size() == corners,
          name + ": corner_edges and corner_verts differ in length" + mesh_is_broken);
    check_range(mesh.corner_verts, mesh.positions.size(), name, "corner_verts");
    check_range(mesh.corner_edges, edge_count, name, "corner_edges");
    check_range(flat(mesh.edge_verts), mesh.positions.size(), name, "edge_verts");
    check_range(flat(mesh.ngon_triangles), mesh.positions.size(), name, "ngon_triangles");
    check_range(mesh.ngon_polygon, polygon_total, name, "ngon_polygon");
    check(mesh.ngon_triangles.size() == mesh.ngon_polygon.size(),
          name + ": ngon_triangles and ngon_polygon differ in length" + mesh_is_broken);
    check(std::is_sorted(mesh.ngon_polygon.begin(), mesh.ngon_polygon.end()),
          name + ": ngon_polygon must ascend" + mesh_is_broken);
    check(std::is_sorted(mesh.polygon_offsets.begin(), mesh.polygon_offsets.end()) &&
              (polygon_total == 0 ||
               (mesh.polygon_offsets.front() == 0 && std::size_t(mesh.polygon_offsets.back()) == corners)),
          name + ": polygon_offsets must ascend from 0 to the number of corners" + mesh_is_broken);
    check_size(mesh.material, polygon_total, name, "material");
    check_size(mesh.occluding, polygon_total, name, "occluding");
    check_size(mesh.one_sided, polygon_total, name, "one_sided");
    check_size(mesh.sharp, edge_count, name, "sharp_edges");
    check_size(mesh.seam, edge_count, name, "seams");
    check_size(mesh.edge_mark, edge_count, name, "edge_marks");
    check_size(mesh.smooth, edge_count, name, "smooth_edges");
}

Surface::Surface(std::string name, const MeshArrays& mesh) : name_(std::move(name)) {
    take_topology(mesh);
    set_positions(mesh.positions);
    edge_corners_ = {};  // of no use to surfaces that never move
}

void Surface::set_positions(In<vec3> moved, bool refit) {
    check(positions.empty() || moved.size() == vertex_count(), name_ + ": " + std::to_string(moved.size()) +
                                                                   " positions for " + std::to_string(vertex_count()) +
                                                                   " vertices; give one for each");
    if (edge_corners_.count() == 0) build_edge_corners();
    positions.resize(moved.size() + 1);
    parallel_for(moved.size(), [&](std::size_t v) { positions[v] = moved[v]; });
    positions.back() = vec3(0.0f);
    jets.clear();
    version_ = next_version();
    cache_->clear();
    if (!refit) lasting_cache_->clear();
    build_geometry();
}

void Surface::set_rest(In<vec3> at_rest) {
    check(at_rest.empty() || at_rest.size() == vertex_count(),
          name_ + ": " + std::to_string(at_rest.size()) + " rest positions for " + std::to_string(vertex_count()) +
              " vertices; give one for each");
    rest_.assign(at_rest.begin(), at_rest.end());
    for (vec3& p : rest_)
        if (!(std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z))) p = vec3(0.0f);
}

void Surface::set_field_options(const FieldOptions& options) {
    check_options(options, name_);
    field_options_ = options;
}

void Surface::take_topology(const MeshArrays& mesh) {
    const std::size_t edge_count = mesh.edge_verts.size();
    const std::size_t polygon_total = mesh.polygon_offsets.empty() ? 0 : mesh.polygon_offsets.size() - 1;
    check_mesh(name_, mesh);

    polygons_.offsets.assign(mesh.polygon_offsets.begin(), mesh.polygon_offsets.end());
    if (polygons_.offsets.empty()) polygons_.offsets.push_back(0);
    corner_verts_ = parallel_map<Index>(mesh.corner_verts.size(), [&](std::size_t c) { return mesh.corner_verts[c]; });
    corner_edges_ = corner_edges_of(mesh);
    const Array<Index> number = edge_numbers(mesh, corner_edges_);
    parallel_for(corner_edges_.size(), [&](std::size_t c) {
        if (corner_edges_[c] != none) corner_edges_[c] = number[corner_edges_[c]];
    });
    edges.resize(edge_count);
    parallel_for(edge_count, [&](std::size_t e) { edges[number[e]] = Edge(mesh.edge_verts[e]); });
    mesh_edges = static_cast<Index>(edge_count);
    polygon_material.assign(mesh.material.begin(), mesh.material.end());
    polygon_material.resize(polygon_total, 0);
    polygon_occludes_.assign(mesh.occluding.begin(), mesh.occluding.end());
    polygon_one_sided.assign(mesh.one_sided.begin(), mesh.one_sided.end());

    edge_marks.assign(edge_count, 0);
    const auto mark = [&](In<std::uint8_t> flags, Mark bit) {
        parallel_for(flags.size(), [&](std::size_t e) {
            if (flags[e]) edge_marks[number[e]] |= bit;
        });
    };
    mark(mesh.sharp, mark_sharp);
    mark(mesh.seam, mark_seam);
    mark(mesh.edge_mark, mark_edge);
    mark(mesh.smooth, mark_smooth);

    ngon_triangles_ = NgonTriangles(mesh);
}

void Surface::build_edge_corners() {
    edge_corners_ = lists_of_ranges<Index>(mesh_edges, [&](const auto& give) {
        for (Index c = 0; c < corner_edges_.size(); ++c)
            if (corner_edges_[c] != none) give(corner_edges_[c], c);
    });
    report_.loose_edges = static_cast<Index>(
        parallel_count(mesh_edges, [&](std::size_t e) { return edge_corners_.size(Index(e)) == 0; }));
}

}  // namespace fovea::mesh
