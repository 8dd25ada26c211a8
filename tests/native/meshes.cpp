// SPDX-License-Identifier: GPL-3.0-or-later
#include "meshes.h"

namespace fovea::meshes {
using namespace draw;

Mesh::Mesh(std::string called, std::vector<vec3> points) : name(std::move(called)), positions(std::move(points)) {}

std::shared_ptr<Surface> Mesh::surface() const {
    auto made = std::make_shared<Surface>(name, arrays());
    made->set_shape(shape);
    return made;
}

int Mesh::edge(int a, int b) {
    const auto [it, inserted] =
        edge_of_.try_emplace({std::min(a, b), std::max(a, b)}, static_cast<int>(edge_verts.size()));
    if (inserted) edge_verts.push_back({a, b});
    return it->second;
}

void Mesh::add_polygon(const std::vector<int>& verts) {
    if (!verts.empty()) edge(verts.back(), verts.front());  // edges are numbered as a Surface does
    for (std::size_t i = 0; i < verts.size(); ++i) {
        corner_verts.push_back(verts[i]);
        corner_edges.push_back(edge(verts[i], verts[(i + 1) % verts.size()]));
    }
    polygon_offsets.push_back(static_cast<int>(corner_verts.size()));
}

std::vector<std::uint8_t> Mesh::edge_flags(const std::vector<int>& edges) const {
    std::vector<std::uint8_t> flags(edge_verts.size(), 0);
    for (int e : edges) flags[e] = 1;
    return flags;
}

Mesh of_polygons(const std::string& name, const std::vector<vec3>& positions, const Polygons& polygons) {
    Mesh mesh(name, positions);
    for (const auto& polygon : polygons) mesh.add_polygon(polygon);
    return mesh;
}

Mesh with_another(const Mesh& first, const Mesh& second) {
    std::vector<vec3> positions = first.positions;
    Polygons polygons;
    for (const auto& [mesh, base] : {std::pair(&first, 0), std::pair(&second, int(first.positions.size()))}) {
        if (base > 0)
            for (const vec3& p : mesh->positions) positions.push_back(p + vec3(5, 0, 0));
        for (std::size_t f = 0; f + 1 < mesh->polygon_offsets.size(); ++f) {
            polygons.push_back({});
            for (int c = mesh->polygon_offsets[f]; c < mesh->polygon_offsets[f + 1]; ++c)
                polygons.back().push_back(mesh->corner_verts[c] + base);
        }
    }
    return of_polygons("two", positions, polygons);
}

Mesh box(vec3 low, vec3 high) {
    std::vector<vec3> p;
    for (int i = 0; i < 8; ++i) p.push_back({i & 1 ? high.x : low.x, i & 2 ? high.y : low.y, i & 4 ? high.z : low.z});
    return of_polygons("box", p, {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}});
}

Mesh tetrahedron() {
    return of_polygons("tetrahedron", {{1, 1, 1}, {1, -1, -1}, {-1, 1, -1}, {-1, -1, 1}},
                       {{0, 1, 2}, {0, 3, 1}, {0, 2, 3}, {1, 3, 2}});
}

Mesh grid(int n, float half) {
    Mesh mesh("grid", {});
    for (int j = 0; j <= n; ++j)
        for (int i = 0; i <= n; ++i) mesh.positions.push_back(half * vec3(2.0f * i / n - 1.0f, 2.0f * j / n - 1.0f, 0));
    for (int j = 0; j < n; ++j)
        for (int i = 0; i < n; ++i) {
            const int v = i + (n + 1) * j;
            mesh.add_polygon({v, v + 1, v + n + 2, v + n + 1});
        }
    return mesh;
}

Mesh sphere(int n) {
    Mesh mesh("sphere", {{0, 0, 1}, {0, 0, -1}});
    const int around = 2 * n;
    for (int j = 1; j < n; ++j)
        for (int i = 0; i < around; ++i) {
            const double t = std::numbers::pi * j / n, p = 2.0 * std::numbers::pi * i / around;
            mesh.positions.push_back(vec3(dvec3(std::sin(t) * std::cos(p), std::sin(t) * std::sin(p), std::cos(t))));
        }
    const auto at = [&](int j, int i) { return 2 + (j - 1) * around + i % around; };
    for (int i = 0; i < around; ++i) {
        mesh.add_polygon({0, at(1, i), at(1, i + 1)});
        for (int j = 1; j + 1 < n; ++j) mesh.add_polygon({at(j, i), at(j + 1, i), at(j + 1, i + 1), at(j, i + 1)});
        mesh.add_polygon({1, at(n - 1, i + 1), at(n - 1, i)});
    }
    return mesh;
}

Mesh cylinder(int n) {
    Mesh mesh("cylinder", {});
    for (int i = 0; i < n; ++i) {
        const double a = 2.0 * std::numbers::pi * i / n;
        mesh.positions.push_back(vec3(dvec3(std::cos(a), std::sin(a), -1)));
        mesh.positions.push_back(vec3(dvec3(std::cos(a), std::sin(a), 1)));
    }
    for (int i = 0; i < n; ++i) {
        const int j = (i + 1) % n;
        mesh.add_polygon({2 * i, 2 * j, 2 * j + 1, 2 * i + 1});
    }
    return mesh;
}

Mesh moebius(int n) {
    Mesh mesh("moebius", {});
    for (int i = 0; i < n; ++i) {
        const double a = 2.0 * std::numbers::pi * i / n;
        for (double s : {-0.4, 0.4}) {
            const double r = 1.0 + s * std::cos(a / 2.0);
            mesh.positions.push_back(vec3(dvec3(r * std::cos(a), r * std::sin(a), s * std::sin(a / 2.0))));
        }
    }
    for (int i = 0; i + 1 < n; ++i) mesh.add_polygon({2 * i, 2 * i + 2, 2 * i + 3, 2 * i + 1});
    mesh.add_polygon({2 * n - 2, 1, 0, 2 * n - 1});
    return mesh;
}

Mesh two_boxes_at_an_edge() {
    Mesh mesh = box();
    mesh.name = "two boxes";
    // The second box spans [1,3] x [1,3]; its edge at x = y = 1 is the first one's 3-7.
    const Mesh other = box(vec3(1, 1, -1), vec3(3, 3, 1));
    std::vector<int> number(8);
    for (int i = 0; i < 8; ++i) {
        number[i] = i == 0 ? 3 : i == 4 ? 7 : static_cast<int>(mesh.positions.size());
        if (i != 0 && i != 4) mesh.positions.push_back(other.positions[i]);
    }
    for (int f = 0; f < 6; ++f) {
        std::vector<int> verts;
        for (int c = 4 * f; c < 4 * f + 4; ++c) verts.push_back(number[other.corner_verts[c]]);
        mesh.add_polygon(verts);
    }
    return mesh;
}

Mesh bent_quad(float lift) {
    return of_polygons("bent quad", {{0, 0, 0}, {1, 0, 0}, {1, 1, lift}, {0, 1, 0}}, {{0, 1, 2, 3}});
}

Mesh concave_quad() {
    return of_polygons("concave quad", {{0, 0, 0}, {2, 1, 0}, {1, 0, 0}, {2, -1, 0}}, {{0, 3, 2, 1}});
}

Mesh l_shape() {
    Mesh mesh = of_polygons("l shape", {{0, 0, 0}, {2, 0, 0}, {2, 1, 0}, {1, 1, 0}, {1, 2, 0}, {0, 2, 0}},
                            {{0, 1, 2, 3, 4, 5}});
    mesh.ngon_triangles = {{0, 1, 3}, {1, 2, 3}, {0, 3, 5}, {3, 4, 5}};
    mesh.ngon_polygon = {0, 0, 0, 0};
    return mesh;
}

}  // namespace fovea::meshes
