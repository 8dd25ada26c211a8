// SPDX-License-Identifier: GPL-3.0-or-later
// Normals, areas and neighbors against closed forms.
#include <algorithm>
#include <gtest/gtest.h>
#include <numeric>
#include <set>

#include <fovea/field/normals.h>
#include <fovea/field/walk.h>

#include "analytic.h"

using namespace fovea;
using namespace fovea::draw;
using namespace fovea::analytic;

namespace {

double area_of(const Surface& surface) {
    double sum = 0.0;
    for (const Triangle& t : surface.triangles) {
        const dvec3 p(surface.positions[t.x]);
        sum += 0.5 * glm::length(glm::cross(dvec3(surface.positions[t.y]) - p, dvec3(surface.positions[t.z]) - p));
    }
    return sum;
}

double sum_of_areas(const Surface& surface) {
    double sum = 0.0;
    for (float area : vertex_areas(surface, *neighbors_of(surface, no_hard_edges))) sum += area;
    return sum;
}

std::size_t within(const Surface& surface, Index v, int rings) {
    Walk walk(surface.vertex_count());
    return walk.gather(*neighbors_of(surface), v, rings).size();
}

}  // namespace

TEST(Normals, AreExactOnSpheresHoweverTheyAreDivided) {
    const vec3 center(3, -2, 1);
    for (const bool irregular : {false, true}) {
        Mesh mesh = ellipsoid(3, irregular, dvec3(2.0)).mesh;
        std::vector<vec3> outward;
        for (vec3& p : mesh.positions) {
            outward.push_back(glm::normalize(p));
            p += center;
        }
        const auto surface = mesh.surface();
        const Array<vec3> normals = vertex_normals(*surface, *neighbors_of(*surface));
        for (std::size_t v = 0; v < normals.size(); ++v) EXPECT_LT(glm::distance(normals[v], outward[v]), 1e-5f);
    }
}

TEST(Neighbors, AreTheVerticesOfTheTrianglesAtAVertexEachOnceInOrder) {
    const auto fan = [](int around, bool closed, bool turned) {
        std::vector<vec3> points{{0, 0, 0}};
        meshes::Polygons polygons;
        for (int i = 0; i < around; ++i)
            points.push_back({std::cos(6.0f * i / around), std::sin(6.0f * i / around), 1});
        for (int i = 0; i + (closed ? 0 : 1) < around; ++i) {
            const int from = around - i, to = i + 1 < around ? from - 1 : around;
            polygons.push_back(turned && i == 1 ? std::vector{0, to, from} : std::vector{0, from, to});
        }
        return meshes::of_polygons("fan", points, polygons);
    };
    std::vector<Mesh> all{meshes::box(), meshes::sphere(9), meshes::moebius(12), meshes::two_boxes_at_an_edge(),
                          torus({.n = 16, .irregular = true}).mesh};
    for (const int around : {3, 7, 8, 9, 20})
        for (const bool closed : {false, true})
            for (const bool turned : {false, true}) all.push_back(fan(around, closed, turned));
    for (const Mesh& mesh : all) {
        const auto surface = mesh.surface();
        const auto neighbors = neighbors_of(*surface, no_hard_edges);
        std::vector<std::set<Index>> expected(surface->vertex_count());
        for (const Triangle& t : surface->triangles)
            for (int i = 0; i < 3; ++i) expected[t[i]].insert({t[(i + 1) % 3], t[(i + 2) % 3]});
        for (Index v = 0; v < surface->vertex_count(); ++v)
            EXPECT_TRUE(std::ranges::equal(neighbors->vertices[v], expected[v])) << mesh.name << ", vertex " << v;
    }
}

TEST(Normals, OfFlatFacesAreTheirs) {
    const auto surface = meshes::grid(5).surface();
    for (const vec3& n : vertex_normals(*surface, *neighbors_of(*surface))) EXPECT_EQ(n, vec3(0, 0, 1));
    Mesh box = meshes::box();  // every edge is hard: a vertex has one of its three faces
    const auto hard = box.surface();
    for (const vec3& n : vertex_normals(*hard, *neighbors_of(*hard)))
        EXPECT_EQ(std::max({std::abs(n.x), std::abs(n.y), std::abs(n.z)}), 1.0f);
    const Array<vec3> soft = vertex_normals(*hard, *neighbors_of(*hard, no_hard_edges));
    for (std::size_t v = 0; v < soft.size(); ++v) EXPECT_GT(glm::dot(soft[v], box.positions[v]), 1.0f);
}

TEST(Areas, OfVerticesSumToThatOfTheSurface) {
    const Mesh obtuse =
        meshes::of_polygons("obtuse", {{0, 0, 0}, {9, 0, 0}, {1, 1, 0}, {4, -1, 2}}, {{0, 1, 2}, {1, 0, 3}});
    for (const Mesh& mesh :
         {obtuse, torus({.n = 32, .irregular = true}).mesh, waves({.n = 16}).mesh, meshes::box(), meshes::sphere(9),
          meshes::moebius(12), meshes::l_shape(), meshes::two_boxes_at_an_edge()}) {
        const auto surface = mesh.surface();
        const double area = area_of(*surface);
        EXPECT_NEAR(sum_of_areas(*surface) / area, 1.0, 1e-6) << mesh.name;
        for (float a : vertex_areas(*surface, *neighbors_of(*surface, no_hard_edges))) EXPECT_GE(a, 0.0f) << mesh.name;
    }
    EXPECT_NEAR(sum_of_areas(*meshes::box().surface()), 24.0, 1e-5);
    EXPECT_NEAR(sum_of_areas(*meshes::grid(7).surface()), 4.0, 1e-5);
}

TEST(Areas, OfAnEvenGridAreItsCells) {
    const auto surface = meshes::grid(4).surface();
    const Array<float> areas = vertex_areas(*surface, *neighbors_of(*surface));
    EXPECT_NEAR(areas[12], 0.25f, 1e-6f) << "inside";
    EXPECT_NEAR(areas[2], 0.125f, 1e-6f) << "at a border";
    EXPECT_NEAR(areas[0], 0.0625f, 1e-6f) << "at a corner";
}

TEST(NeighborsOf, RingsOfARegularTriangulation) {
    // Vertices of six triangles each: 1 + 3 r (r + 1) within r rings.
    const auto surface = torus({.n = 48}).mesh.surface();
    for (Index v : {0u, 77u, 500u})
        for (int r : {0, 1, 2, 3, 4, 5}) EXPECT_EQ(within(*surface, v, r), std::size_t(1 + 3 * r * (r + 1)));
}

TEST(NeighborsOf, AreMutualWhereNothingIsHard) {
    for (const Mesh& mesh : {ellipsoid(2, true).mesh, waves({.n = 12, .irregular = true}).mesh, meshes::moebius(24)}) {
        const auto surface = mesh.surface();
        const auto around = neighbors_of(*surface, no_hard_edges);
        for (Index v = 0; v < surface->vertex_count(); ++v)
            for (const Index w : around->vertices[v])
                EXPECT_TRUE(std::ranges::binary_search(around->vertices[w], v)) << mesh.name;
        EXPECT_EQ(around->vertices.values.size(), 2 * (surface->edges.size()))
            << mesh.name << ": each edge from both ends";
    }
}

TEST(NeighborsOf, AWalkDoesNotCrossAHardEdge) {
    // The lid of a box, 5 x 5 vertices: from its middle a walk of any length finds the lid with its rim.
    Mesh mesh = meshes::grid(4);
    for (int i : {0, 1, 2, 3}) {  // a wall down from the side y = -1
        const int base = int(mesh.positions.size());
        for (int k = 0; k < 2; ++k) mesh.positions.push_back(mesh.positions[i + k] + vec3(0, 0, -1));
        mesh.add_polygon({base, base + 1, i + 1, i});
    }
    EXPECT_EQ(within(*mesh.surface(), 12, 20), 25u);
    EXPECT_GT(within(*mesh.surface(), 2, 20), 0u);
}
