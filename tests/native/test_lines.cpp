// SPDX-License-Identifier: GPL-3.0-or-later
// Line definitions on surfaces whose lines are known.
#include <glm/gtc/quaternion.hpp>
#include <gtest/gtest.h>
#include <random>

#include "analytic.h"
#include "drawing.h"

using namespace fovea;
using namespace fovea::draw;
using namespace fovea::meshes;
using namespace fovea::drawing;

namespace {

std::set<Index> edges_of(const Drawing& drawing, Index placement = 0) {
    std::set<Index> edges;
    for (const auto& [edge, kinds] : drawing.lines(placement)) edges.insert(edge);
    return edges;
}

std::set<Index> edges_of(const Mesh& mesh, const View& view, const LineSet& set, dmat4 at = dmat4(1.0)) {
    return edges_of(Drawing({place(mesh, at)}, view, {set}));
}

/// The vertices of these edges: the same whatever their numbers.
std::set<std::pair<Index, Index>> ends_of(const Mesh& mesh, const View& view, const LineSet& set,
                                          dmat4 at = dmat4(1.0)) {
    const auto surface = mesh.surface();
    std::set<std::pair<Index, Index>> ends;
    for (const Index edge : edges_of(mesh, view, set, at))
        ends.insert(std::minmax({surface->edges[edge].x, surface->edges[edge].y}));
    return ends;
}

/// Two unit squares that share an edge (edge 2), folded by an angle between their normals.
Mesh folded(double degrees) {
    const double a = glm::radians(degrees);
    const vec3 up(dvec3(std::cos(a), 0, std::sin(a)));
    return of_polygons("folded", {{-1, 0, 0}, {0, 0, 0}, {0, 1, 0}, {-1, 1, 0}, up, up + vec3(0, 1, 0)},
                       {{0, 1, 2, 3}, {1, 4, 5, 2}});
}

}  // namespace

TEST(Lines, TheRegistryFindsDefinitionsByName) {
    std::set<std::string> names;
    for (const LineDefinition* definition : line_definitions()) {
        EXPECT_EQ(&definition_called(definition->name), definition);
        EXPECT_TRUE(names.insert(definition->name).second) << definition->name << " twice";
        for (const Parameter& p : definition->parameters) EXPECT_TRUE(p.low <= p.value && p.value <= p.high) << p.name;
    }
    EXPECT_THROW(definition_index("outline"), std::invalid_argument);
    EXPECT_LE(line_definitions().size(), 8 * sizeof(Kinds));
}

TEST(Contour, OfABoxFromItsCornerHasSixEdges) {
    const Drawing drawing({place(box())}, corner_view, {line_set({"contour"}, 179)});
    EXPECT_EQ(edges_of(drawing).size(), 6u);
    ASSERT_EQ(drawing.paths.count(), 1u);
    EXPECT_TRUE(drawing.paths.closed[0]);
}

TEST(Contour, OfABoxSeenStraightOnIsItsFrontFace) {
    EXPECT_EQ(edges_of(box(), perspective({0, -5, 0}, {0, 0, 0}), line_set({"contour"})).size(), 4u);
    EXPECT_EQ(edges_of(box(), orthographic({0, -5, 0}, {0, 0, 0}, 6), line_set({"contour"})).size(), 4u);
}

TEST(Contour, OfABoxInAnElevationIsItsFrontFaceHoweverItIsTurned) {
    std::mt19937 random(7);
    std::uniform_real_distribution<double> turn(0.0, 6.28);
    const Mesh mesh = box();
    for (int i = 0; i < 20; ++i) {
        const dmat4 turned = glm::mat4_cast(glm::dquat(dvec3(turn(random), turn(random), turn(random))));
        const dvec3 eye(turned * dvec4(0, -5, 0, 0));
        const auto ends = ends_of(mesh, orthographic(eye, {0, 0, 0}, 6), line_set({"contour"}), turned);
        EXPECT_EQ(ends.size(), 4u) << i;
        for (const auto& [a, b] : ends)
            EXPECT_TRUE(mesh.positions[a].y < 0.0f && mesh.positions[b].y < 0.0f) << i << ": " << a << " to " << b;
    }
}

TEST(Contour, OfASphereIsOneLoopNearTheAnalyticCircle) {
    const int n = 48;
    const dvec3 eye(3, -4, 2);
    const Drawing drawing({place(sphere(n))}, perspective(eye, {0, 0, 0}), {line_set({"contour"}, 180)});
    double closed = 0.0, all = 0.0;
    for (Index p = 0; p < drawing.paths.count(); ++p) {
        double length = 0.0;
        for (Index i = drawing.paths.rows.begin(p); i + 1 < drawing.paths.rows.end(p); ++i)
            length += glm::distance(drawing.paths.points_obj[i], drawing.paths.points_obj[i + 1]);
        all += length;
        if (drawing.paths.closed[p]) closed += length;
    }
    EXPECT_EQ(closed, all) << "without borders every contour is closed";
    // Points p of the contour have p . eye = 1; edges are off it by at most one facet.
    const double facet = std::numbers::pi / n;
    for (const vec3& point : drawing.paths.points_obj)
        EXPECT_NEAR(glm::dot(dvec3(point), glm::normalize(eye)), 1.0 / glm::length(eye), 1.5 * facet);
}

TEST(Contour, IsTheSameWhicheverWayFacesAreTurned) {
    std::mt19937 random(7);
    const Mesh shapes[] = {box(), sphere(12), two_boxes_at_an_edge(), tetrahedron()};
    for (const Mesh& shape : shapes) {
        const auto expected = ends_of(shape, corner_view, line_set({"contour"}));
        const Mesh mixed = flipped(shape, [&](int) { return random() % 2 == 0; });
        EXPECT_EQ(ends_of(mixed, corner_view, line_set({"contour"})), expected) << shape.name;
        EXPECT_EQ(ends_of(mixed, corner_view, line_set({"crease"})), ends_of(shape, corner_view, line_set({"crease"})));
        EXPECT_FALSE(expected.empty());
    }
}

TEST(Contour, RunsAlongADiagonalOnlyWhereABentPolygonTurnsAway) {
    // Edge-on from the side where one half of the bent quad faces away.
    const Mesh mesh = bent_quad(1.0f);
    const auto surface = mesh.surface();
    const Index diagonal = surface->mesh_edges;
    const auto seen_from = [&](dvec3 eye) {
        return edges_of(mesh, perspective(eye, {0.5, 0.5, 0}), line_set({"contour"}));
    };
    EXPECT_EQ(seen_from({0.5, 0.5, 9}), std::set<Index>()) << "both halves face the viewer";
    const dvec3 n0(surface->facet_plane[0]), n1(surface->facet_plane[1]);
    const dvec3 between = glm::normalize(n0 - n1);  // one half faces it, the other does not
    EXPECT_EQ(seen_from(dvec3(0.5, 0.5, 0.2) + 9.0 * between), std::set<Index>{diagonal});
}

TEST(Contour, HasNoBordersAndABorderNoContours) {
    const View view = perspective({4, 0.3, 2}, {0, 0, 0});
    const Drawing drawing({place(cylinder(32))}, view, {line_set({"contour", "border"})});
    std::map<Kinds, int> count;
    for (const auto& [edge, kinds] : drawing.lines()) ++count[kinds];
    EXPECT_EQ(count[bit_of("border")], 64);
    EXPECT_EQ(count[bit_of("contour")], 2) << "where the cylinder turns away, left and right";
    EXPECT_EQ(count.size(), 2u);
}

TEST(Crease, BeginsAtItsAngle) {
    const View view = perspective({0, 0.5, 6}, {0, 0.5, 0});
    for (const double fold : {10.0, 30.0, 80.0, 150.0}) {
        EXPECT_TRUE(edges_of(folded(fold), view, line_set_with("crease", {fold - 0.05, 1})).count(2)) << fold;
        EXPECT_FALSE(edges_of(folded(fold), view, line_set_with("crease", {fold + 0.05, 1})).count(2)) << fold;
    }
    EXPECT_EQ(edges_of(folded(90), view, line_set({"crease"})), std::set<Index>{2}) << "borders are no creases";
}

TEST(Crease, SharpMarksAreASwitch) {
    Mesh mesh = grid(2);
    mesh.sharp = mesh.edge_flags({2, 3});
    ASSERT_EQ(mesh.edge_verts[2], glm::ivec2(1, 4)) << "an inner edge";
    ASSERT_EQ(mesh.edge_verts[3], glm::ivec2(4, 3));
    const View view = perspective({0, -1, 6}, {0, 0, 0});
    EXPECT_EQ(edges_of(mesh, view, line_set_with("crease", {30, 1})), (std::set<Index>{2, 3}));
    EXPECT_EQ(edges_of(mesh, view, line_set_with("crease", {30, 0})), std::set<Index>());
}

TEST(Crease, ThreeFacesAtAnEdgeAreACrease) {
    Mesh mesh = folded(0.0);
    mesh.positions.push_back({0, 0, 1});
    mesh.positions.push_back({0, 1, 1});
    mesh.add_polygon({1, 6, 7, 2});
    EXPECT_EQ(edges_of(mesh, perspective({1, 0.5, 6}, {0, 0.5, 0}), line_set({"crease"})), std::set<Index>{2});
}

TEST(Border, IsWhereASurfaceEnds) {
    EXPECT_EQ(edges_of(grid(3), corner_view, line_set({"border"})).size(), 12u);
    EXPECT_EQ(edges_of(box(), corner_view, line_set({"border"})).size(), 0u);
    EXPECT_EQ(edges_of(moebius(24), corner_view, line_set({"border"})).size(), 48u);
    const Drawing strip({place(moebius(24))}, corner_view, {line_set({"border"}, 180)});
    EXPECT_EQ(strip.paths.count(), 1u) << "the border of a moebius strip is one loop";
    EXPECT_TRUE(strip.paths.closed[0]);
}

TEST(MaterialBoundary, LiesBetweenMaterials) {
    Mesh mesh = grid(2);
    EXPECT_TRUE(edges_of(mesh, corner_view, line_set({"material_boundary"})).empty());
    mesh.material = {0, 1, 0, 1};
    EXPECT_EQ(edges_of(mesh, corner_view, line_set({"material_boundary"})).size(), 2u);
    mesh.material = {0, 1, 2, 3};
    EXPECT_EQ(edges_of(mesh, corner_view, line_set({"material_boundary"})).size(), 4u);
}

TEST(EdgeMark, TakesSeamsWhenAsked) {
    Mesh mesh = grid(2);
    mesh.positions.push_back({0, 0, 1});
    const int loose = mesh.edge(0, 9);
    mesh.edge_mark = mesh.edge_flags({1, loose});
    mesh.seam = mesh.edge_flags({2});
    EXPECT_EQ(edges_of(mesh, corner_view, line_set_with("edge_mark", {0})), std::set<Index>{1}) << "no loose edges";
    EXPECT_EQ(edges_of(mesh, corner_view, line_set_with("edge_mark", {1})), (std::set<Index>{1, 2}));
}

TEST(Silhouette, IsTheOuterBoundaryOnly) {
    // Two spheres in one mesh, one before the other: the front one's contour lies on the back one.
    const View view = perspective({0, -8, 0}, {0, 0, 0});
    Mesh both = sphere(16);
    const Mesh back = sphere(16);
    const int base = static_cast<int>(both.positions.size());
    for (const vec3& p : back.positions) both.positions.push_back(3.0f * p + vec3(0, 6, 0));
    for (std::size_t f = 0; f + 1 < back.polygon_offsets.size(); ++f) {
        std::vector<int> verts;
        for (int c = back.polygon_offsets[f]; c < back.polygon_offsets[f + 1]; ++c)
            verts.push_back(base + back.corner_verts[c]);
        both.add_polygon(verts);
    }
    const auto contours = edges_of(both, view, line_set({"contour"}));
    const auto silhouettes = edges_of(both, view, line_set({"silhouette"}));
    const int first_of_back = static_cast<int>(sphere(16).edge_verts.size());
    for (Index e : contours) EXPECT_EQ(silhouettes.count(e), int(e) >= first_of_back ? 1u : 0u) << e;
    EXPECT_EQ(silhouettes.size(), contours.size() / 2);

    // As two placements, each has its own silhouette.
    const Drawing apart({place(sphere(16)), place(sphere(16), moved({0, 6, 0}) * scaled(dvec3(3)), 2)}, view,
                        {line_set({"silhouette"})});
    EXPECT_EQ(edges_of(apart, 0).size() + edges_of(apart, 1).size(), contours.size());
}

TEST(Silhouette, IsThereWhereHardlyAnythingLooksOutBehind) {
    // Two squares in one mesh, the farther one larger by so many pixels all around; mirrored, too.
    const View view = orthographic({0, 0, 5}, {0, 0, 0}, 4.0);
    const double px = 4.0 / view.width;
    const auto silhouettes = [&](double larger_px, const dmat4& placed) {
        Mesh mesh("squares", {});
        for (const auto& [half, z] : {std::pair{1.0, 1.0}, std::pair{1.0 + larger_px * px, 0.0}}) {
            const int first = static_cast<int>(mesh.positions.size());
            for (const dvec2 corner : {dvec2(-1, -1), dvec2(1, -1), dvec2(1, 1), dvec2(-1, 1)})
                mesh.positions.push_back(vec3(corner * half, z));
            mesh.add_polygon({first, first + 1, first + 2, first + 3});
        }
        return edges_of(Drawing({place(mesh, placed)}, view, {line_set({"silhouette"})}), 0);
    };
    for (const dmat4& placed : {dmat4(1.0), scaled(dvec3(-1, 1, 1))}) {
        EXPECT_EQ(silhouettes(0.5, placed).size(), 8u);
        EXPECT_EQ(silhouettes(1.4, placed).size(), 8u);
        EXPECT_EQ(silhouettes(1.6, placed).size(), 4u);
        EXPECT_EQ(silhouettes(20.0, placed), (std::set<Index>{4, 5, 6, 7}));
    }
}

TEST(Silhouette, GoesOnWhereTheSurfaceComesNearer) {
    // A step in a slope that rises towards the viewer: what goes on from the step is nearer than its edge.
    const View view = perspective({0, -8, 1}, {0, 0, 0});
    Mesh mesh("step", {{-1, 2, 1},
                       {1, 2, 1},
                       {1, 0, 0},
                       {-1, 0, 0},
                       {-1, 0.2, 0.09},
                       {1, 0.2, 0.09},
                       {1, -2, -1.01},
                       {-1, -2, -1.01}});
    mesh.add_polygon({3, 2, 1, 0});
    mesh.add_polygon({7, 6, 5, 4});
    const auto silhouettes = edges_of(mesh, view, line_set({"silhouette"}));
    EXPECT_EQ(edges_of(mesh, view, line_set({"border"})).size(), 8u);
    EXPECT_EQ(silhouettes.count(Index(mesh.edge(2, 3))), 0u) << "the surface goes on";
    EXPECT_EQ(silhouettes.count(Index(mesh.edge(0, 1))), 1u);
    EXPECT_EQ(silhouettes.count(Index(mesh.edge(6, 7))), 1u);
}

TEST(Silhouette, OfARoughMeshIsOneOutline) {
    // The contour of an irregular mesh doubles back behind its own facets, and is no outline there.
    const Drawing drawing({place(analytic::icosphere(4, true))}, perspective({4, -5, 3}, dvec3(0)),
                          {line_set({"silhouette"})});
    std::set<int> degrees;  // around the middle, that the longest path passes
    for (Index p = 0; p < drawing.paths.count(); ++p) {
        std::set<int> passed;
        for (Index q = 0; q < drawing.clipped.pieces.count(); ++q)
            for (Index i = drawing.clipped.pieces.begin(q); i < drawing.clipped.pieces.end(q); ++i)
                if (drawing.clipped.path[q] == p) {
                    const dvec2 from = dvec2(drawing.clipped.px[i]) - dvec2(320, 240);
                    passed.insert(int(glm::degrees(std::atan2(from.y, from.x)) / 10.0 + 18.0));
                }
        if (passed.size() > degrees.size()) degrees = passed;
    }
    EXPECT_GE(degrees.size(), 36u);
}

TEST(Lines, AnEdgeOfSeveralKindsAppearsOnce) {
    Mesh mesh = box();
    mesh.material = {0, 1, 2, 3, 4, 5};
    mesh.edge_mark.assign(12, 1);
    const Drawing drawing({place(mesh)}, corner_view,
                          {line_set({"contour", "silhouette", "crease", "border", "material_boundary", "edge_mark"})});
    const auto lines = drawing.lines();
    ASSERT_EQ(lines.size(), 12u);
    int contours = 0;
    for (const auto& [edge, kinds] : lines) {
        EXPECT_EQ(kinds & ~bit_of("contour") & ~bit_of("silhouette"),
                  bit_of("crease") | bit_of("material_boundary") | bit_of("edge_mark"));
        EXPECT_EQ((kinds & bit_of("contour")) != 0, (kinds & bit_of("silhouette")) != 0) << "a box is convex";
        contours += (kinds & bit_of("contour")) != 0;
    }
    EXPECT_EQ(contours, 6);
}

TEST(Lines, MoveWithTheObjectAndTheCamera) {
    const LineSet set = line_set({"contour", "crease", "border"});
    for (const Mesh& mesh : {sphere(12), box(), cylinder(20), bent_quad()}) {
        const auto expected = edges_of(mesh, corner_view, set);
        for (const double size : {1e-3, 1.0, 1e3}) {
            const dmat4 motion = moved(size * dvec3(3, -2, 1)) *
                                 glm::mat4_cast(glm::angleAxis(1.1, glm::normalize(dvec3(1, 2, -1)))) *
                                 scaled(dvec3(size));
            View view = corner_view;
            view.world_to_view = scaled(dvec3(size)) * corner_view.world_to_view * glm::inverse(motion);
            view = with_near(view, 0.1 * size);
            EXPECT_EQ(edges_of(mesh, view, set, motion), expected) << mesh.name << " " << size;
        }
    }
}

TEST(Lines, OfAMirroredObjectAreMirrored) {
    const LineSet set = line_set({"contour"});
    View mirrored = corner_view;
    mirrored.world_to_view = corner_view.world_to_view * scaled({-1, 1, 1});
    for (const Mesh& mesh : {sphere(12), tetrahedron()})
        EXPECT_EQ(edges_of(mesh, mirrored, set), edges_of(mesh, corner_view, set, scaled({-1, 1, 1}))) << mesh.name;
}
