// SPDX-License-Identifier: GPL-3.0-or-later
#include "random_mesh.h"

namespace fovea::fuzz {

using meshes::Mesh;

std::vector<vec3> places(Choices& choices, int count) {
    std::vector<vec3> all(count);
    for (vec3& p : all) p = vec3{choices.about_one(), choices.about_one(), choices.about_one()};
    return all;
}

namespace {

std::vector<int> some_of(Choices& choices, int count, int size) {
    std::vector<int> chosen;
    for (int i = 0; i < size && count > 0; ++i) chosen.push_back(choices.below(count));
    return chosen;
}

Mesh soup(Choices& choices) {
    const int count = choices.between(1, 30);
    Mesh mesh("", places(choices, count));
    for (int f = choices.between(0, 30); f > 0; --f) mesh.add_polygon(some_of(choices, count, choices.between(0, 7)));
    return mesh;
}

Mesh terrain(Choices& choices) {
    Mesh mesh = meshes::grid(choices.between(1, 8));
    const float height = choices.one_of({0.0f, 1e-6f, 0.1f, 1.0f});
    for (vec3& p : mesh.positions) p.z = height * float(choices.about_one());
    return mesh;
}

/// One polygon of many corners, flat or not, sometimes with a triangulation.
Mesh disc(Choices& choices) {
    const int n = choices.chance(0.02) ? 500 : choices.between(3, 20);
    std::vector<vec3> around;
    std::vector<int> polygon;
    const float height = choices.one_of({0.0f, 0.0f, 0.3f});
    for (int i = 0; i < n; ++i) {
        const double a = 2.0 * std::numbers::pi * i / n;
        around.push_back(vec3(std::cos(a), std::sin(a), height * choices.about_one()));
        polygon.push_back(i);
    }
    Mesh mesh = meshes::of_polygons("", around, {polygon});
    for (int i = 1; i + 1 < n && n > 4; ++i)
        mesh.ngon_triangles.push_back({0, i, i + 1}), mesh.ngon_polygon.push_back(0);
    return mesh;
}

Mesh shape(Choices& choices) {
    switch (choices.below(11)) {
        case 0:
            return soup(choices);
        case 1:
            return terrain(choices);
        case 2:
            return disc(choices);
        case 3:
            return meshes::box();
        case 4:
            return meshes::sphere(choices.between(2, 8));
        case 5:
            return meshes::cylinder(choices.between(3, 20));
        case 6:
            return meshes::moebius(choices.between(3, 20));
        case 7:
            return meshes::two_boxes_at_an_edge();
        case 8:
            return meshes::bent_quad(float(choices.about_one()));
        case 9:
            return meshes::l_shape();
        default:
            return Mesh("", places(choices, choices.below(4)));
    }
}

// What spoils a mesh, in its positions and polygons.

void with_broken_numbers(Choices& choices, Mesh& mesh) {
    for (const int v : some_of(choices, int(mesh.positions.size()), choices.between(1, 4)))
        mesh.positions[v][choices.below(3)] = float(choices.broken());
}

void collapsed(Choices& choices, Mesh& mesh) {
    const int count = int(mesh.positions.size());
    for (const int v : some_of(choices, count, choices.between(1, 10)))
        mesh.positions[v] = mesh.positions[choices.below(count)];
}

void flattened(Choices& choices, Mesh& mesh) {
    const int axis = choices.below(3);
    const float left = choices.one_of({0.0f, 1e-20f, 1e-4f});
    for (vec3& p : mesh.positions) p[axis] *= left;
}

void rounded(Choices& choices, Mesh& mesh) {
    const float step = choices.one_of({0.25f, 0.5f, 1.0f});
    for (vec3& p : mesh.positions) p = glm::round(p / step) * step;
}

void sized(Choices& choices, Mesh& mesh) {
    const float by = float(choices.chance(0.5) ? choices.size(-4.0, 4.0) : choices.size(-38.0, 38.0));
    for (vec3& p : mesh.positions) p *= by;
}

void far_away(Choices& choices, Mesh& mesh) {
    const float distance = float(choices.size(0.0, 9.0));
    const vec3 by = distance * places(choices, 1)[0];
    for (vec3& p : mesh.positions) p += by;
}

void with_more_polygons(Choices& choices, Mesh& mesh) {
    const int count = int(mesh.positions.size());
    for (int f = choices.between(1, 6); f > 0; --f) mesh.add_polygon(some_of(choices, count, choices.between(0, 5)));
}

/// Polygons once more, as they are or turned around.
void doubled(Choices& choices, Mesh& mesh) {
    const int polygons = int(mesh.polygon_offsets.size()) - 1;
    for (const int f : some_of(choices, polygons, choices.between(1, 6))) {
        std::vector<int> verts(mesh.corner_verts.begin() + mesh.polygon_offsets[f],
                               mesh.corner_verts.begin() + mesh.polygon_offsets[f + 1]);
        if (choices.chance(0.5)) std::reverse(verts.begin(), verts.end());
        mesh.add_polygon(verts);
    }
}

void with_loose_edges(Choices& choices, Mesh& mesh) {
    const int count = int(mesh.positions.size());
    for (const int v : some_of(choices, count, 4)) mesh.edge(v, choices.below(count));
}

void turned(Choices& choices, Mesh& mesh) {
    const std::uint64_t which = choices.bits();
    mesh = meshes::flipped(mesh, [&](int f) { return which >> (f % 64) & 1; });
}

constexpr void (*spoilers[])(Choices&, Mesh&) = {
    with_broken_numbers, collapsed, flattened,        rounded, sized, far_away,
    with_more_polygons,  doubled,   with_loose_edges, turned};

std::vector<std::uint8_t> flags(Choices& choices, std::size_t count) {
    std::vector<std::uint8_t> set(count);
    const double share = choices.one_of({0.05, 0.5, 1.0});
    for (auto& flag : set) flag = choices.chance(share);
    return set;
}

void mark(Choices& choices, Mesh& mesh) {
    const std::size_t edges = mesh.edge_verts.size(), polygons = mesh.polygon_offsets.size() - 1;
    for (auto* of_edges : {&mesh.sharp, &mesh.seam, &mesh.edge_mark, &mesh.smooth})
        if (choices.chance(0.3)) *of_edges = flags(choices, edges);
    for (auto* of_polygons : {&mesh.occluding, &mesh.one_sided})
        if (choices.chance(0.3)) *of_polygons = flags(choices, polygons);
    if (!choices.chance(0.3)) return;
    for (std::size_t f = 0; f < polygons; ++f) mesh.material.push_back(choices.between(-2, 4));
}

/// Makes one of the arrays, of numbers of elements mostly, one that does not fit the others.
void contradict(Choices& choices, Mesh& mesh) {
    const auto change = [&](auto& values) {
        const int wrong = choices.one_of({-1, -2, 1, 0, 1 << 20, std::numeric_limits<int>::max(),
                                          std::numeric_limits<int>::min(), int(mesh.positions.size())});
        if (values.empty() || choices.chance(0.2)) {
            values.resize(std::size_t(choices.below(2 + 2 * int(values.size()))));
        } else {
            using Value = std::remove_reference_t<decltype(values[0])>;
            values[std::size_t(choices.below(int(values.size())))] = Value(wrong);
        }
    };
    switch (choices.below(9)) {
        case 0:
            return change(mesh.edge_verts);
        case 1:
            return change(mesh.corner_verts);
        case 2:
            return change(mesh.corner_edges);
        case 3:
            return change(mesh.polygon_offsets);
        case 4:
            return change(mesh.ngon_triangles);
        case 5:
            return change(mesh.ngon_polygon);
        case 6:
            return change(mesh.material);
        case 7:
            return change(choices.chance(0.5) ? mesh.occluding : mesh.one_sided);
        default:
            return change(choices.one_of({&mesh.sharp, &mesh.seam, &mesh.edge_mark, &mesh.smooth})[0]);
    }
}

}  // namespace

void spoil(Choices& choices, Mesh& mesh) { choices.one_of(spoilers)(choices, mesh); }

Mesh random_mesh(Choices& choices) {
    Mesh mesh = shape(choices);
    for (int i = choices.below(4); i > 0; --i) spoil(choices, mesh);
    if (choices.chance(0.5)) mark(choices, mesh);
    if (choices.chance(0.06)) contradict(choices, mesh);
    return mesh;
}

}  // namespace fovea::fuzz
