// SPDX-License-Identifier: GPL-3.0-or-later
// Strands and points: meshes of what has no faces in Blender, and their lines.
#include <gtest/gtest.h>

#include <fovea/mesh/spheres.h>
#include <fovea/mesh/strands.h>
#include <fovea/scene/bodies.h>

#include "drawing.h"

using namespace fovea;
using namespace fovea::draw;
using namespace fovea::drawing;

namespace {

/// Strands with the same radius everywhere.
OwnedStrands strands(const std::vector<std::vector<vec3>>& lines, float radius) {
    OwnedStrands made;
    made.offsets = {0};
    for (const auto& line : lines) {
        made.points.insert(made.points.end(), line.begin(), line.end());
        made.offsets.push_back(int(made.points.size()));
    }
    made.radii.assign(made.points.size(), radius);
    return made;
}

std::shared_ptr<const Surface> surface(const OwnedMesh& mesh) {
    return std::make_shared<const Surface>("Shape", mesh.arrays());
}

Placement placed(const OwnedMesh& mesh, std::uint64_t id = 1) { return {surface(mesh), dmat4(1.0), id}; }

const View from_front = perspective({0, -10, 0}, {0, 0, 0});
const std::vector<vec3> upright{{0, 0, -1}, {0, 0, 0}, {0, 0, 1}};

/// Extent of all clipped points in pixels: low, high.
std::pair<dvec2, dvec2> extent(const Drawing& drawing) {
    dvec2 low(1e9), high(-1e9);
    for (const vec3& p : drawing.paths.points_obj) {
        const dvec2 px = pixel_of(drawing.view, dvec3(p));
        low = glm::min(low, px), high = glm::max(high, px);
    }
    return {low, high};
}

}  // namespace

TEST(Strands, APrismIsClosedAndFacesOutwards) {
    const auto made = surface(strand_prisms("Hair", strands({upright, {{2, 0, 0}, {3, 1, 0}}}, 0.1f).strands(), true));
    EXPECT_EQ(made->report().loose_edges, 0u);
    EXPECT_EQ(made->report().degenerate_polygons, 0u);
    EXPECT_EQ(made->report().inconsistent_edges, 0u);
    for (Index e = 0; e < made->edges.size(); ++e) EXPECT_EQ(made->edge_rows.size(e), 2u) << e;
    double volume = 0.0;
    for (const Triangle& t : made->triangles) {
        const auto at = [&](Index v) { return dvec3(made->positions[v]); };
        volume += glm::dot(at(t.x), glm::cross(at(t.y), at(t.z))) / 6.0;
    }
    EXPECT_GT(volume, 0.0);
    EXPECT_EQ(made->triangles.size(), 3u * 2u * (2u + 1u) + 2u * 2u);
}

TEST(Strands, APrismIsAsWideAsTheStrandFromEverySide) {
    const auto mesh = strand_prisms("Hair", strands({upright}, 0.5f).strands(), true);
    double sum = 0.0;
    constexpr int views = 180;
    for (int i = 0; i < views; ++i) {
        const double angle = glm::radians(2.0 * i);
        const dvec3 right(std::cos(angle), std::sin(angle), 0.0);
        double low = 1e9, high = -1e9;
        for (const vec3& p : mesh.positions) {
            low = std::min(low, glm::dot(dvec3(p), right));
            high = std::max(high, glm::dot(dvec3(p), right));
        }
        EXPECT_GT(high - low, 0.90);
        EXPECT_LT(high - low, 1.05);
        sum += high - low;
    }
    EXPECT_NEAR(sum / views, 1.0, 1e-3) << "in the mean";
}

TEST(Strands, AStrandHidesWhatIsBehindIt) {
    const auto front = strands({upright}, 0.2f);
    const auto behind = strands({{{-2, 2, 0}, {0, 2, 0}, {2, 2, 0}}}, 0.0f);
    const LineSet border = line_set({"border"});
    const Placement wire = placed(strand_wires("Wire", behind.strands()), 2);
    const Drawing free({wire}, from_front, {border});
    const Drawing hidden({wire, placed(strand_prisms("Hair", front.strands(), true))}, from_front, {border});
    const double across = glm::distance(pixel_of(from_front, {-0.2, 0, 0}), pixel_of(from_front, {0.2, 0, 0}));
    EXPECT_NEAR(free.visible_px(0), free.total_px(0), 1e-6);
    EXPECT_NEAR(free.visible_px(0) - hidden.visible_px(0), across, 0.1 * across);
    // One of a material that hides nothing does not.
    const Drawing clear({wire, placed(strand_prisms("Hair", front.strands(), false))}, from_front, {border});
    EXPECT_NEAR(clear.visible_px(0), clear.total_px(0), 1e-6);
}

TEST(Strands, AStrandHasOneClosedContour) {
    for (const double turn : {0.0, 17.0, 60.0, 100.0}) {
        const dvec3 eye = 10.0 * dvec3(std::sin(glm::radians(turn)), -std::cos(glm::radians(turn)), 0.2);
        const auto mesh = strand_prisms("Hair", strands({upright}, 0.1f).strands(), true);
        const Drawing drawing({placed(mesh)}, perspective(eye, {0, 0, 0}), {line_set({"contour"})});
        EXPECT_EQ(drawing.paths.count(), 1u) << turn;
        EXPECT_TRUE(drawing.paths.closed[0]) << turn;
        EXPECT_GT(drawing.visible_px(0), 0.96 * drawing.total_px(0)) << turn << ": all but beside the six corners";
    }
}

TEST(Strands, APrismFollowsItsStrandWithoutTwist) {
    // Round a bend of 180 degrees, each side of the prism stays a line: its length is that of the strand, about.
    std::vector<vec3> bend;
    for (int i = 0; i <= 16; ++i)
        bend.push_back({std::cos(glm::radians(11.25f * i)), 0.0f, std::sin(glm::radians(11.25f * i))});
    const auto mesh = strand_prisms("Hair", strands({bend}, 0.01f).strands(), true);
    for (int k = 0; k < 3; ++k) {
        double length = 0.0;
        for (std::size_t i = k; i + 3 < mesh.positions.size(); i += 3)
            length += glm::distance(mesh.positions[i], mesh.positions[i + 3]);
        EXPECT_NEAR(length, glm::pi<double>(), 0.04 * glm::pi<double>()) << k;
    }
}

TEST(Strands, PointsThatCoincideLeaveTheRestOfAStrand) {
    const auto made =
        surface(strand_prisms("Hair", strands({{{0, 0, 0}, {0, 0, 0}, {0, 0, 1}, {0, 0, 1}}}, 0.1f).strands(), true));
    EXPECT_EQ(made->report().non_finite_vertices, 0u);
    EXPECT_EQ(made->triangles.size(), 6u + 2u);
}

TEST(Strands, ATipOfNoRadiusHasArea) {
    auto tapered = strands({upright}, 0.1f);
    tapered.radii[2] = 0.0f;
    EXPECT_EQ(surface(strand_prisms("Hair", tapered.strands(), true))->report().degenerate_polygons, 0u);
}

TEST(Strands, AWireIsOnePathWithTheStrandsPoints) {
    const std::vector<vec3> line{{-1, 0, 0}, {-0.3f, 0, 0.2f}, {0.4f, 0, 0.1f}, {1, 0, 0.5f}};
    const Drawing drawing({placed(strand_wires("Wire", strands({line}, 0.0f).strands()))}, from_front,
                          {line_set({"border"})});
    ASSERT_EQ(drawing.paths.count(), 1u);
    EXPECT_FALSE(drawing.paths.closed[0]);
    ASSERT_EQ(drawing.paths.points_obj.size(), line.size());
    for (std::size_t i = 0; i < line.size(); ++i) EXPECT_EQ(drawing.paths.points_obj[i], line[i]);
    EXPECT_NEAR(drawing.visible_px(0), drawing.total_px(0), 1e-6);
}

TEST(Strands, RoundedOnesPassThroughTheirPoints) {
    const auto coarse = strands({upright, {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {2, 1, 0}}}, 0.1f);
    const auto fine = rounded_strands("Hair", coarse.strands(), 4);
    EXPECT_EQ(fine.offsets, (Array<int>{0, 9, 22}));
    for (int s = 0; s < 2; ++s)
        for (int i = coarse.offsets[s]; i < coarse.offsets[s + 1]; ++i)
            EXPECT_EQ(fine.points[fine.offsets[s] + 4 * (i - coarse.offsets[s])], coarse.points[i]);
    // The middle of the straight part between two corners, by the formula of Catmull and Rom.
    const vec3 middle = fine.points[fine.offsets[1] + 6];
    EXPECT_NEAR(middle.x, 1.0f, 1e-6f);
    EXPECT_NEAR(middle.y, 0.5f, 1e-6f);
    for (const float radius : fine.radii) EXPECT_NEAR(radius, 0.1f, 1e-6f);
}

TEST(Strands, WhatDoesNotFitTogetherIsRefusedByName) {
    const auto one = strands({{{0, 0, 0}}}, 0.1f);
    auto uneven = strands({upright}, 0.1f);
    uneven.radii.pop_back();
    for (const OwnedStrands* wrong : {&one, static_cast<const OwnedStrands*>(&uneven)}) {
        try {
            strand_prisms("Fringe", wrong->strands(), true);
            ADD_FAILURE() << "taken";
        } catch (const std::invalid_argument& error) {
            EXPECT_EQ(std::string(error.what()).rfind("Fringe: ", 0), 0u) << error.what();
        }
    }
    const std::vector<vec3> centers(2);
    const std::vector<float> radii(1);
    EXPECT_THROW(spheres("Dust", centers, radii, true), std::invalid_argument);
}

TEST(Spheres, APointDrawsTheContourOfASphereOfItsRadius) {
    const std::vector<vec3> center{{0.5f, 0, 0.25f}};
    const std::vector<float> radius{0.8f};
    const Drawing drawing({placed(spheres("Points", center, radius, true))}, from_front, {line_set({"contour"})});
    ASSERT_EQ(drawing.paths.count(), 1u);
    EXPECT_TRUE(drawing.paths.closed[0]);
    for (const vec3& p : drawing.paths.points_obj) EXPECT_NEAR(glm::distance(p, center[0]), radius[0], 0.002f);
    // What a camera sees of a sphere: a circle of tan(asin(r / d)), here near the middle of the picture.
    const double d = glm::length(dvec3(0.5, 10, 0.25)), unit = pixel_of(from_front, {1, 0, 0}).x - 320.0;
    const double expected = 2.0 * 10.0 * unit * std::tan(std::asin(0.8 / d));
    const auto [low, high] = extent(drawing);
    EXPECT_NEAR(high.x - low.x, expected, 0.01 * expected);
    EXPECT_NEAR(high.y - low.y, expected, 0.01 * expected);
}

TEST(Spheres, AreClosedAtEveryLevelAndAsLargeAsTrueOnes) {
    for (const std::size_t count : {std::size_t(1), std::size_t(500), std::size_t(2000), std::size_t(10000),
                                    std::size_t(100000), std::size_t(200000)}) {
        // Only the first few are built: their level is that of `count`.
        const int level = sphere_level(count);
        EXPECT_LE(level, sphere_level(count / 2));
        EXPECT_LE(count * (level < 0 ? 8 : 20 << (2 * level)), 2'000'000u);
    }
    EXPECT_EQ(sphere_level(1), 4);
    EXPECT_EQ(sphere_level(100'000), 0);
    EXPECT_EQ(sphere_level(1'000'000), -1);
    for (const std::size_t count : {std::size_t(1), std::size_t(20'000), std::size_t(110'000)}) {
        const std::vector<vec3> centers(count);
        const std::vector<float> radii(count, 1.0f);
        const auto made = surface(spheres("Points", centers, radii, true));
        const std::size_t each = made->triangles.size() / count;
        double area = 0.0;
        for (std::size_t t = 0; t < each; ++t) {
            const auto at = [&](Index v) { return dvec3(made->positions[v]); };
            const Triangle& tri = made->triangles[t];
            const dvec3 n = glm::cross(at(tri.y) - at(tri.x), at(tri.z) - at(tri.x));
            EXPECT_GT(glm::dot(n, at(tri.x)), 0.0) << "outwards";
            area += 0.5 * glm::length(n);
        }
        EXPECT_NEAR(area, 4.0 * glm::pi<double>(), 1e-4) << each << " faces";
        for (Index e = 0; e < 3; ++e) EXPECT_EQ(made->edge_rows.size(e), 2u);
    }
}

TEST(Border, HasLooseEdgesUnlessTheyAreOff) {
    meshes::Mesh mesh = meshes::grid(2);
    mesh.positions.push_back({0, 0, 1});
    mesh.edge(4, 9);
    const View view = perspective({4, -5, 3}, {0, 0, 0});
    EXPECT_EQ(Drawing({place(mesh)}, view, {line_set({"border"})}).lines().size(), 9u);
    EXPECT_EQ(Drawing({place(mesh)}, view, {line_set_with("border", {0.0})}).lines().size(), 8u);
    EXPECT_EQ(Drawing({place(mesh)}, view, {line_set({"silhouette"})}).lines().size(), 8u) << "it bounds nothing";
    // One of no length, or with a vertex that is nowhere, is no line.
    for (const vec3& broken : {vec3(0), vec3(0, 0, NAN), vec3(0, INFINITY, 1)}) {
        mesh.positions.back() = broken;
        EXPECT_EQ(Drawing({place(mesh)}, view, {line_set({"border"})}).lines().size(), 8u);
    }
    // A face that is left out leaves no loose edges behind.
    meshes::Mesh flat("flat", {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}});
    flat.add_polygon({0, 1, 2});
    EXPECT_EQ(Drawing({place(flat)}, view, {line_set({"border"})}).lines().size(), 0u);
}

TEST(Border, LooseEdgesHaveTheFirstMaterial) {
    const Placement wire = placed(strand_wires("Wire", strands({upright}, 0.0f).strands()));
    for (const bool lined : {true, false}) {
        LineSet set = line_set({"border"});
        set.materials.row = {0};
        set.materials.masks = {{std::uint8_t(lined), 1}};
        EXPECT_EQ(Drawing({wire}, from_front, {set}).paths.count(), lined ? 1u : 0u);
    }
}
