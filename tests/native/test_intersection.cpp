// SPDX-License-Identifier: GPL-3.0-or-later
// Intersections of surfaces whose curves are known.
#include <gtest/gtest.h>

#include <fovea/scene/crossings.h>

#include "intersections.h"

using namespace fovea;
using namespace fovea::draw;
using namespace fovea::intersections;

TEST(Intersection, OfTwoSpheresIsACircle) {
    const int n = 48;
    const Found found(
        {put(sphere(n), moved({-0.5, 0, 0}), 1), put(sphere(n), moved({0.5, 0, 0}) * turned(0.7, {1, 2, 3}), 2)});
    ASSERT_EQ(found.count, 1u);
    EXPECT_EQ(found.closed, 1u);
    const double radius = std::sqrt(0.75), facet = 1.0 - std::cos(std::numbers::pi / n);
    EXPECT_NEAR(found.length, 2 * std::numbers::pi * radius, 0.01);
    for (const dvec3& p : found.at) {
        EXPECT_NEAR(p.x, 0.0, 2 * facet);
        EXPECT_NEAR(std::hypot(p.y, p.z), radius, 3 * facet);
    }
}

TEST(Intersection, OfABoxThroughAPlaneIsARectangle) {
    const Found found({put(grid(7, 3), moved({0, 0, 0.25}), 1), put(box(), dmat4(1.0), 2)});
    ASSERT_EQ(found.count, 1u);
    EXPECT_EQ(found.closed, 1u);
    EXPECT_NEAR(found.length, 8.0, 1e-6);
    for (const dvec3& p : found.at) {
        EXPECT_NEAR(p.z, 0.25, 1e-6);
        EXPECT_NEAR(std::max(std::abs(p.x), std::abs(p.y)), 1.0, 1e-6);
    }
}

TEST(Intersection, OfATorusAndAPlaneIsTwoCircles) {
    const Mesh ring = torus(2, 0.5, 64, 32);
    const double chord = 64 * 2 * std::sin(std::numbers::pi / 64), around = 32 * 2 * std::sin(std::numbers::pi / 32);
    // Through all vertices of both equators, which lie in the plane exactly; and across.
    const Found flat({put(ring, dmat4(1.0), 1), put(grid(1, 4), dmat4(1.0), 2)});
    ASSERT_EQ(flat.lengths.size(), 2u);
    EXPECT_EQ(flat.closed, 2u);
    EXPECT_NEAR(flat.lengths[0], 1.5 * chord, 1e-4);
    EXPECT_NEAR(flat.lengths[1], 2.5 * chord, 1e-4);
    const Found upright({put(ring, dmat4(1.0), 1), put(grid(1, 4), turned(std::numbers::pi / 2, {1, 0, 0}), 2)});
    ASSERT_EQ(upright.lengths.size(), 2u);
    EXPECT_EQ(upright.closed, 2u);
    for (const double length : upright.lengths) EXPECT_NEAR(length, 0.5 * around, 1e-4);
}

TEST(Intersection, WithinAnObjectIsWhereItsPartsCross) {
    const dmat4 other = moved({0.7, 0.6, 0.5}) * turned(0.4, {3, 1, 2});
    const Found apart({put(box(), dmat4(1.0), 1), put(box(), other, 2)});
    const Found together({put(joined({{box(), dmat4(1.0)}, {box(), other}}), dmat4(1.0), 1)});
    ASSERT_EQ(apart.count, 1u);
    EXPECT_EQ(apart.closed, 1u);
    EXPECT_EQ(together.count, 1u);
    EXPECT_EQ(together.closed, 1u);
    EXPECT_NEAR(together.length, apart.length, 1e-5);
    EXPECT_EQ(Found({put(joined({{box(), dmat4(1.0)}, {box(), other}}), dmat4(1.0), 1)}, {1, 0}).count, 0u);
    EXPECT_EQ(Found({put(box(), dmat4(1.0), 1), put(box(), other, 2)}, {0, 1}).count, 0u);
}

TEST(Intersection, OfASurfaceThatCrossesItself) {
    const Found found({put(eight(40), dmat4(1.0), 1)});
    ASSERT_EQ(found.count, 1u);
    EXPECT_EQ(found.closed, 0u) << "it ends at the borders";
    EXPECT_NEAR(found.length, 2.0, 1e-5);
    for (const dvec3& p : found.at) EXPECT_NEAR(std::hypot(p.x, p.y), 0.0, 1e-6);
    // Through a vertex of both parts at once: two cones tip to tip in a mesh, one through the other.
    const Mesh cross =
        of_polygons("cross", {{0, 0, 0}, {1, -1, 0}, {1, 1, 0}, {0.5, 0, -1}, {0.5, 0, 1}}, {{0, 1, 2}, {0, 3, 4}});
    const Found at_vertex({put(cross, dmat4(1.0), 1)});
    ASSERT_EQ(at_vertex.count, 1u);
    EXPECT_NEAR(at_vertex.length, 0.5, 1e-6);
}

TEST(Intersection, OfShearedQuadsHasOnlyTheTrianglesThatThereAre) {
    // Fours of triangles are compared, and these are two each: of what fills them up, all coordinates of a map without
    // zeros and of one sign are infinite alike.
    const Affine sheared(dvec3(1.0, 0.2, 0.3), dvec3(0.1, 1.0, 0.4), dvec3(0.3, 0.2, 1.0), dvec3(0.0));
    Mesh upright = grid(1), placed = grid(1);
    for (std::size_t v = 0; v < upright.positions.size(); ++v) {
        const vec3 p = upright.positions[v];
        upright.positions[v] = {p.x, 0.1f, p.y};
        placed.positions[v] = vec3(sheared * dvec4(dvec3(upright.positions[v]), 1.0));
    }
    const auto flat = grid(1).surface(), second = upright.surface(), mapped = placed.surface();
    const Cancel never;
    const Crossings found = cross(*flat, *second, sheared, never), expected = cross(*flat, *mapped, Affine(1.0), never);
    ASSERT_FALSE(found.empty());
    ASSERT_EQ(found.size(), expected.size());
    for (const Crossing& crossing : found)
        for (const Index triangle : crossing.triangle) EXPECT_LT(triangle, 2u);
}

TEST(Intersection, NeighborsDoNotIntersect) {
    for (const Mesh& mesh : {box(), sphere(24), two_boxes_at_an_edge(), moebius(24), grid(8), tetrahedron(),
                             bent_quad(), l_shape(), torus(2, 0.5, 24, 12), cylinder(12)}) {
        EXPECT_EQ(Found({put(mesh, turned(0.3, {1, 2, 3}), 1)}).count, 0u) << mesh.name;
        EXPECT_EQ(Found({put(split(mesh), dmat4(1.0), 1)}).count, 0u) << mesh.name << ", split";
    }
}

TEST(Intersection, AVertexFarAwayMakesNoPairsOfAllTriangles) {
    // Of 80,000 triangles all are nearer to each other than the tolerance of contact, which is a share of the size.
    Mesh mesh = meshes::relief(200, [](double x, double y) { return 0.1 * std::sin(9 * x) * std::cos(7 * y); });
    const int first = static_cast<int>(mesh.positions.size());
    for (const vec3& far : {vec3(1e9f, 0, 0), vec3(1e9f, 1e9f, 0), vec3(1e9f, 0, 1e9f)}) mesh.positions.push_back(far);
    mesh.add_polygon({first, first + 1, first + 2});
    EXPECT_TRUE(scene::cross_itself(*mesh.surface(), Cancel()).empty());
}

TEST(Intersection, SurfacesThatTouchHaveNone) {
    const Mesh floor = grid(3, 4);
    const dmat4 on_floor = moved({0.3, 0.1, 1});
    const dmat4 motions[] = {dmat4(1.0), moved({5, 3, 1}) * turned(1.1, {1, 2, 3}),
                             turned(2.2, {-3, 1, 1}) * scaled(dvec3(3))};
    for (const dmat4& motion : motions) {
        EXPECT_EQ(Found({put(floor, motion, 1), put(box(), motion * on_floor, 2)}).count, 0u) << "a box on a floor";
        EXPECT_EQ(Found({put(floor, motion, 2), put(box(), motion * on_floor, 1)}).count, 0u);
        EXPECT_EQ(Found({put(joined({{floor, dmat4(1.0)}, {box(), on_floor}}), motion, 1)}).count, 0u)
            << "in one object";
        EXPECT_EQ(Found({put(box(), motion, 1), put(box(), motion * moved({2, 0.5, 0.5}), 2)}).count, 0u)
            << "side by side";
        EXPECT_EQ(Found({put(box(), motion, 1), put(box(), motion, 2)}).count, 0u) << "in the same place";
        EXPECT_EQ(Found({put(floor, motion, 1), put(tetrahedron(), motion * moved({0, 0, 1}), 2)}).count, 0u)
            << "on an edge";
    }
    for (const double depth : {1e-7, -1e-7})
        EXPECT_EQ(Found({put(floor, dmat4(1.0), 1), put(box(), moved({0.3, 0.1, 1 - depth}), 2)}).count, 0u);
    const Found sunk({put(floor, dmat4(1.0), 1), put(box(), moved({0.3, 0.1, 0.999}), 2)});
    EXPECT_EQ(sunk.count, 1u);
    EXPECT_EQ(sunk.closed, 1u);
}

TEST(Intersection, OfFlushBoxesIsWhereTheyCross) {
    // Tops and bottoms lie in the same planes; two sides of the second cross a face of the first.
    const Found found({put(box(), dmat4(1.0), 1), put(box(), moved({1, 0.1, 0}) * scaled({1, 0.5, 1}), 2)});
    ASSERT_EQ(found.count, 2u);
    EXPECT_EQ(found.closed, 0u);
    for (const double length : found.lengths) EXPECT_NEAR(length, 2.0, 1e-5);
    for (const dvec3& p : found.at) {
        EXPECT_NEAR(p.x, 1.0, 1e-6);
        EXPECT_NEAR(std::abs(p.y - 0.1), 0.5, 1e-6);
    }
}
