// SPDX-License-Identifier: GPL-3.0-or-later
// What the polygons of a surface stand for, and the lines that suit it.
#include <cmath>
#include <gtest/gtest.h>
#include <numbers>
#include <set>

#include <fovea/field/shape.h>

#include "drawing.h"

using namespace fovea;
using namespace fovea::draw;
using namespace fovea::meshes;
using namespace fovea::drawing;

namespace {

Mesh automatic(Mesh mesh) {
    mesh.shape = Shape::automatic;
    return mesh;
}

Shape decided(const Mesh& mesh) { return shape_of(*automatic(mesh).surface()); }

Mesh shaded_smooth(Mesh mesh) {
    mesh.smooth.assign(mesh.edge_verts.size(), 1);
    return mesh;
}

/// In [-1, 1], the same on every machine.
double noise(std::uint32_t n) {
    n = (n ^ 61) ^ (n >> 16);
    n *= 9;
    n = (n ^ (n >> 4)) * 0x27d4eb2d;
    return double(n ^ (n >> 15)) / 0x7fffffff - 1.0;
}

double waves(double x, double y) { return 0.15 * std::sin(3.0 * x + 0.5) * std::cos(2.5 * y); }

/// A round bump of radius 1.5 in 12 rings, and a floor around it, hardly sloped, up to `radius` without further rings.
Mesh bump_on_floor(double radius) {
    constexpr int rings = 12, sides = 24;
    Mesh mesh("bump", {{0, 0, 0.15f}});
    const auto at = [](int ring, int side) { return ring == 0 ? 0 : 1 + (ring - 1) * sides + side % sides; };
    for (int ring = 1; ring <= rings + 1; ++ring)
        for (int side = 0; side < sides; ++side) {
            const double r = ring <= rings ? 1.5 * ring / rings : radius, a = 2.0 * std::numbers::pi * side / sides;
            const double z = 0.15 * std::exp(-r * r);
            mesh.positions.push_back({float(r * std::cos(a)), float(r * std::sin(a)), float(z)});
            mesh.add_polygon({at(ring - 1, side), at(ring, side), at(ring, side + 1)});
            if (ring > 1) mesh.add_polygon({at(ring - 1, side), at(ring, side + 1), at(ring - 1, side + 1)});
        }
    return mesh;
}

/// Kinds of the edges that a placement's lines of these sets have.
std::set<Kinds> kinds_of(const Mesh& mesh, const std::vector<LineSet>& sets) {
    const Drawing drawn({place(mesh)}, corner_view, sets);
    return {drawn.paths.kinds.begin(), drawn.paths.kinds.end()};
}

/// The creases that the default parameters find, as pairs of vertices.
std::set<std::pair<Index, Index>> creases(const Mesh& mesh) {
    const auto surface = mesh.surface();
    const Drawing drawn({{surface, dmat4(1.0), 1, usage_draw}}, corner_view, {line_set({"crease"})});
    std::set<std::pair<Index, Index>> found;
    for (const auto& [edge, kinds] : drawn.lines()) {
        const Edge ends = surface->edges[edge];
        found.insert({std::min(ends.x, ends.y), std::max(ends.x, ends.y)});
    }
    return found;
}

TEST(Shape, PlanesCylindersAndBoxesAreHard) {
    EXPECT_EQ(decided(box()), Shape::hard);
    EXPECT_EQ(decided(shaded_smooth(box())), Shape::hard);
    EXPECT_EQ(decided(grid(8)), Shape::hard);
    EXPECT_EQ(decided(cylinder(48)), Shape::hard);
    EXPECT_EQ(decided(shaded_smooth(cylinder(12))), Shape::hard);
}

TEST(Shape, WhatBendsBothWaysFinelyIsSmooth) {
    EXPECT_EQ(decided(sphere(24)), Shape::smooth);
    EXPECT_EQ(decided(relief(40, waves)), Shape::smooth);
}

TEST(Shape, CoarseFacesAreMeantUnlessTheirShadingIsSmooth) {
    const Mesh coarse = relief(6, [](double x, double y) { return 0.35 * std::sin(4 * x) * std::cos(3 * y); });
    EXPECT_EQ(decided(coarse), Shape::hard);
    EXPECT_EQ(decided(shaded_smooth(coarse)), Shape::rounded);
}

TEST(Shape, IsNotSmoothForTheRimsOfSmallBumpsOnALargeFloor) {
    // The triangles of the floor have a corner or two at the bump, where it bends both ways.
    EXPECT_EQ(decided(bump_on_floor(2.0)), Shape::smooth);
    EXPECT_EQ(decided(bump_on_floor(4.0)), Shape::rounded);
}

TEST(Shape, IsThatOfTheSurfaceWhateverItsSizeAndPlace) {
    for (const Mesh& mesh : {sphere(24), cylinder(20), relief(12, waves)})
        for (const double size : {1e-3, 1.0, 1e3}) {
            Mesh other = mesh;
            for (vec3& p : other.positions) p = vec3(size) * vec3(p.y, p.z, p.x) + vec3(float(size), 0, 0);
            EXPECT_EQ(decided(other), decided(mesh)) << mesh.name << size;
        }
}

TEST(Shape, OfALargeSurfaceIsDecidedByPartOfItsTriangles) {
    const auto both_ways = [](double x, double y) { return 0.4 * std::sin(6.0 * x) * std::cos(5.0 * y); };
    const auto one_way = [](double x, double) { return 0.4 * std::sin(6.0 * x); };
    EXPECT_EQ(decided(relief(460, both_ways)), Shape::smooth);
    EXPECT_EQ(decided(relief(460, one_way)), Shape::hard);
}

TEST(Shape, ThatIsSetStands) {
    Mesh mesh = sphere(24);
    for (const Shape shape : {Shape::hard, Shape::rounded, Shape::smooth}) {
        mesh.shape = shape;
        EXPECT_EQ(shape_of(*mesh.surface()), shape);
    }
}

TEST(SuitedLines, AreOfTheMeshOnHardAndOfTheSmoothShapeOnSmoothSurfaces) {
    LineSet suited = line_set({"contour", "smooth_contour"});
    suited.surfaces = Surfaces::suited;
    EXPECT_EQ(kinds_of(automatic(sphere(24)), {suited}), (std::set<Kinds>{bit_of("smooth_contour")}));
    EXPECT_EQ(kinds_of(automatic(box()), {suited}), (std::set<Kinds>{bit_of("contour")}));
}

TEST(SuitedLines, KeepTheContourOfTheMeshWhereNoSetAsksForTheSmoothOne) {
    LineSet suited = line_set({"contour"});
    suited.surfaces = Surfaces::suited;
    EXPECT_EQ(kinds_of(automatic(sphere(24)), {suited}), (std::set<Kinds>{bit_of("contour")}));
}

TEST(SuitedLines, OfASetForOneShapeAreOnNoOther) {
    LineSet set = line_set({"contour"});
    set.surfaces = Surfaces::hard;
    EXPECT_TRUE(kinds_of(automatic(sphere(24)), {set}).empty());
    EXPECT_FALSE(kinds_of(automatic(box()), {set}).empty());
}

TEST(Creases, OfASmoothSurfaceAreItsFoldsAndNoNoise) {
    const int n = 40;
    const auto rough = [&](double x, double y) {
        const auto seed = std::uint32_t(std::lround(1000 * (x + 2)) * 7919 + std::lround(1000 * (y + 2)));
        return 0.01 * noise(seed) + waves(x, y);
    };
    Mesh noisy = relief(n, rough),
         folded = relief(n, [&](double x, double y) { return rough(x, y) - 1.2 * std::abs(x); });
    noisy.shape = folded.shape = Shape::smooth;
    EXPECT_TRUE(creases(noisy).empty());
    std::set<std::pair<Index, Index>> fold;
    for (Index j = 0; j < n; ++j) fold.insert({n / 2 + (n + 1) * j, n / 2 + (n + 1) * (j + 1)});
    EXPECT_EQ(creases(folded), fold);
    noisy.shape = Shape::hard;
    EXPECT_FALSE(creases(noisy).empty()) << "the noise is as steep as creases are";
}

TEST(Creases, AreNotBetweenTheSidesOfATubeThatIsShadedSmooth) {
    EXPECT_EQ(creases(cylinder(8)).size(), 8u);
    EXPECT_TRUE(creases(shaded_smooth(cylinder(8))).empty());
}

TEST(Creases, OfABoxStayHoweverItIsShaded) {
    EXPECT_EQ(creases(shaded_smooth(box())).size(), 12u);
    Mesh marked = shaded_smooth(cylinder(8));
    marked.sharp = marked.edge_flags({marked.edge(0, 1)});
    EXPECT_EQ(creases(marked).size(), 1u) << "marked sharp";
}

}  // namespace
