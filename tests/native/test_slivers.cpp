// SPDX-License-Identifier: GPL-3.0-or-later
// Triangles of a polygon whose corners lie almost on a line: the polygon is one face, with or without them.
#include <glm/gtc/quaternion.hpp>
#include <gtest/gtest.h>
#include <random>

#include <fovea/visibility/own_sides.h>

#include "drawing.h"

using namespace fovea;
using namespace fovea::draw;
using namespace fovea::meshes;
using namespace fovea::drawing;

namespace {

using Ends = std::set<std::pair<Index, Index>>;

/// The vertices of the edges that are lines of these definitions.
Ends lines_of(const Mesh& mesh, const View& view, const std::vector<const char*>& names) {
    const Drawing drawing({place(mesh)}, view, {line_set(names)});
    Ends ends;
    for (const auto& [edge, kinds] : drawing.lines()) {
        const Edge e = drawing.scene.placements[0].surface->edges[edge];
        ends.insert(std::minmax({e.x, e.y}));
    }
    return ends;
}

/// A square of side .5 with a corner 1, amid the side 0-2, that is off by `lift`; and the square beyond that side.
Mesh floor_with_a_lifted_vertex(vec3 lift = {0, 0, 2e-3f}) {
    Mesh mesh = of_polygons("floor",
                            {{0, 0, 0},
                             vec3(0.25f, 0, 0) + lift,
                             {0.5f, 0, 0},
                             {0.5f, 0.5f, 0},
                             {0, 0.5f, 0},
                             {0.5f, -0.5f, 0},
                             {0, -0.5f, 0}},
                            {{0, 1, 2, 3, 4}, {6, 5, 2, 1, 0}});
    mesh.ngon_triangles = {{0, 1, 2}, {0, 2, 3}, {0, 3, 4}, {6, 5, 2}, {6, 2, 1}, {6, 1, 0}};
    mesh.ngon_polygon = {0, 0, 0, 1, 1, 1};
    return mesh;
}
const Ends border_of_floor{{0, 4}, {3, 4}, {2, 3}, {2, 5}, {5, 6}, {0, 6}};

/// One polygon, a quad bent along its diagonal 0-2, with a corner amid its side 0-1 that is a little too low.
Mesh bent_quad_with_a_lifted_vertex() {
    Mesh mesh = of_polygons("bent", {{0, 0, 0}, {1, 0, 0}, {1, 1, 1}, {0, 1, 0}, {0.5f, 0, -4e-3f}}, {{0, 4, 1, 2, 3}});
    mesh.ngon_triangles = {{0, 4, 1}, {0, 1, 2}, {0, 2, 3}};
    mesh.ngon_polygon = {0, 0, 0};
    return mesh;
}

/// One polygon, `n` strips of length 1 around a half pipe and a flat flange.
Mesh half_pipe(int n, float radius) {
    Mesh mesh("half pipe", {});
    std::vector<int> there, back;
    const auto row = [&](float y, float z) {
        there.push_back(int(mesh.positions.size()));
        back.insert(back.begin(), there.back() + 1);
        mesh.positions.push_back({0, y, z});
        mesh.positions.push_back({1, y, z});
    };
    row(-1, radius);
    for (int k = 0; k <= n; ++k) {
        const double a = std::numbers::pi * k / n;
        row(float(radius * std::sin(a)), float(radius * std::cos(a)));
    }
    for (std::size_t r = 1; r < there.size(); ++r) {
        const int at = there[r - 1];
        mesh.ngon_triangles.insert(mesh.ngon_triangles.end(), {{at, at + 1, at + 2}, {at + 2, at + 1, at + 3}});
    }
    std::vector<int> corners(there.rbegin(), there.rend());
    corners.insert(corners.end(), back.rbegin(), back.rend());
    mesh.add_polygon(corners);
    mesh.ngon_polygon.assign(mesh.ngon_triangles.size(), 0);
    return mesh;
}

/// The box with a vertex amid each edge, `off` away from it in a random direction. Every face is an octagon.
Mesh box_with_split_edges(float off, int seed) {
    std::mt19937 random(seed);
    std::normal_distribution<float> normal;
    const Mesh whole = box();
    Mesh mesh("box", whole.positions);
    for (const glm::ivec2& e : whole.edge_verts) {
        const vec3 away(normal(random), normal(random), normal(random));
        mesh.positions.push_back(0.5f * (whole.positions[e.x] + whole.positions[e.y]) + off * glm::normalize(away));
    }
    for (int f = 0; f < 6; ++f) {
        std::vector<int> corners;
        for (int c = 4 * f; c < 4 * f + 4; ++c) {
            corners.push_back(whole.corner_verts[c]);
            corners.push_back(8 + whole.corner_edges[c]);
        }
        mesh.add_polygon(corners);
    }
    return mesh;
}

/// Both halves of edges of the box in the mesh above.
Ends halves(const Ends& edges) {
    const Mesh whole = box();
    Ends ends;
    for (int e = 0; e < int(whole.edge_verts.size()); ++e) {
        const Index a = whole.edge_verts[e].x, b = whole.edge_verts[e].y, between = 8 + e;
        if (edges.contains(std::minmax({a, b}))) ends.insert({{a, between}, {b, between}});
    }
    return ends;
}

/// The triangles of each facet, by their vertices.
std::set<std::set<std::set<Index>>> facets_of(const Mesh& mesh) {
    const auto surface = mesh.surface();
    std::vector<std::set<std::set<Index>>> facets(surface->facet_count());
    for (Index t = 0; t < surface->triangles.size(); ++t) {
        const Triangle& v = surface->triangles[t];
        facets[surface->triangle_facet[t]].insert({v.x, v.y, v.z});
    }
    return {facets.begin(), facets.end()};
}

Mesh moved_by(Mesh mesh, const dmat4& motion) {
    for (vec3& p : mesh.positions) p = vec3(motion * dvec4(dvec3(p), 1.0));
    return mesh;
}

/// Views from all around, at least 15 degrees above the floor.
std::vector<View> views_from_above() {
    std::vector<View> views;
    for (const double up : {15.0, 40.0, 70.0})
        for (int i = 0; i < 12; ++i) {
            const double a = glm::radians(30.0 * i + 7.0), b = glm::radians(up);
            const dvec3 from(std::cos(a) * std::cos(b), std::sin(a) * std::cos(b), std::sin(b));
            views.push_back(perspective(2.0 * from, {0.25, 0, 0}));
            views.push_back(orthographic(2.0 * from, {0.25, 0, 0}, 2.0));
        }
    return views;
}

}  // namespace

TEST(Slivers, AFloorWithALiftedVertexHasItsBorderAndNothingElse) {
    // The sliver 0-1-2 stands upright, falls over, or is folded under the floor.
    for (const vec3 lift : {vec3(0, 0, 1e-3f), vec3(0, 0, -1e-3f), vec3(0, 3e-4f, 1e-3f), vec3(0, -3e-4f, -1e-3f),
                            vec3(0, -1e-4f, 1e-3f), vec3(0.1f, 0, 2e-3f), vec3(0, 0, 4e-3f)})
        for (const View& view : views_from_above())
            EXPECT_EQ(lines_of(floor_with_a_lifted_vertex(lift), view, {"silhouette", "contour", "crease", "border"}),
                      border_of_floor);
}

TEST(Slivers, AFacetIsATriangleWithItsSlivers) {
    const Mesh mesh = floor_with_a_lifted_vertex();
    const auto surface = mesh.surface();
    EXPECT_EQ(facets_of(mesh), (std::set<std::set<std::set<Index>>>{
                                   {{0, 1, 2}, {0, 2, 3}}, {{0, 3, 4}}, {{2, 5, 6}}, {{1, 2, 6}}, {{0, 1, 6}}}));
    EXPECT_EQ(surface->edges.size(), surface->mesh_edges + 3) << "no diagonal inside of a facet";
    for (Index f = 0; f < surface->facet_count(); ++f)
        EXPECT_GT(surface->facet_plane[f].z, 0.99f) << "a facet has the plane of its triangle that is no sliver";
}

TEST(Slivers, AreFoundWhateverTheScaleTheTurnAndTheOrder) {
    std::mt19937 random(3);
    const Mesh mesh = floor_with_a_lifted_vertex();
    const auto expected = facets_of(mesh);
    for (const double scale : {1e-9, 1e-3, 1e4, 1e9})
        EXPECT_EQ(facets_of(moved_by(mesh, scaled(dvec3(scale)))), expected) << scale;
    for (int i = 0; i < 20; ++i) {
        const dvec3 axis(random() % 100, random() % 100, 1 + random() % 100);
        const dmat4 turn = glm::mat4_cast(glm::angleAxis(0.3 * i, glm::normalize(axis)));
        EXPECT_EQ(facets_of(moved_by(mesh, turn)), expected) << i;
    }
    for (int i = 0; i < 20; ++i) {
        Mesh other = mesh;
        std::shuffle(other.ngon_triangles.begin(), other.ngon_triangles.begin() + 3, random);
        std::shuffle(other.ngon_triangles.begin() + 3, other.ngon_triangles.end(), random);
        for (glm::ivec3& t : other.ngon_triangles)
            for (int k = random() % 3; k > 0; --k) t = {t.y, t.z, t.x};
        EXPECT_EQ(facets_of(other), expected) << i;
    }
    for (int i = 0; i < 5; ++i) {
        Mesh other("floor", mesh.positions);
        std::vector<int> corners{0, 1, 2, 3, 4};
        std::ranges::rotate(corners, corners.begin() + i);
        other.add_polygon(corners);
        other.add_polygon({6, 5, 2, 1, 0});
        other.ngon_triangles = mesh.ngon_triangles;
        other.ngon_polygon = mesh.ngon_polygon;
        EXPECT_EQ(facets_of(other), expected) << i;
    }
}

TEST(Slivers, ABoxWithSplitEdgesHasTheLinesOfABox) {
    const Mesh whole = box();
    for (const float off : {1e-4f, 2e-3f, 5e-3f})
        for (int seed = 0; seed < 6; ++seed) {
            const Mesh split = box_with_split_edges(off, seed);
            for (const dvec3 eye : {dvec3(4, -5, 3), dvec3(-3, -4, -2.5), dvec3(0.3, 6, 0.2), dvec3(-5, 0.4, 3)})
                for (const View& view : {perspective(eye, {0, 0, 0}), orthographic(eye, {0, 0, 0}, 6)})
                    for (const char* name : {"contour", "silhouette", "crease"})
                        EXPECT_EQ(lines_of(split, view, {name}), halves(lines_of(whole, view, {name})))
                            << name << " " << off << " " << seed;
        }
}

TEST(Slivers, AFoldOfABentPolygonStaysAContourBesideThem) {
    const Mesh mesh = bent_quad_with_a_lifted_vertex();
    const auto surface = mesh.surface();
    ASSERT_EQ(surface->facet_count(), 2u);
    const dvec3 between = glm::normalize(dvec3(surface->facet_plane[0]) - dvec3(surface->facet_plane[1]));
    const View view = perspective(dvec3(0.5, 0.5, 0.2) + 9.0 * between, {0.5, 0.5, 0});
    EXPECT_EQ(lines_of(mesh, view, {"contour"}), (Ends{{0, 2}}));
    EXPECT_EQ(lines_of(mesh, perspective({0.5, 0.5, 9}, {0.5, 0.5, 0}), {"contour"}), Ends());
}

TEST(Slivers, OfATwistedStripStandForThemselves) {
    // Nothing in the polygon is wider, and its halves may well face opposite ways.
    const Mesh strip = of_polygons("strip", {{0, 0, 0}, {1, 0, 0}, {1, 0, 5e-3f}, {0, 5e-3f, 0}}, {{0, 1, 2, 3}});
    EXPECT_EQ(strip.surface()->facet_count(), 2u);
    EXPECT_EQ(bent_quad(0.02f).surface()->facet_count(), 2u);
}

TEST(Slivers, GoWithATriangleOnlyAsFarAsTheyLieInItsPlane) {
    const Mesh pipe = half_pipe(64, 0.1f);
    const auto surface = pipe.surface();
    EXPECT_GT(surface->facet_count(), 90u) << "a curved polygon stays curved";
    EXPECT_LT(surface->facet_count(), surface->triangles.size());
    const double longest = std::sqrt(2.0);
    for (Index t = 0; t < surface->triangles.size(); ++t) {
        const vec4 plane = surface->facet_plane[surface->triangle_facet[t]];
        for (int k = 0; k < 3; ++k)
            EXPECT_NEAR(glm::dot(vec3(plane), surface->positions[surface->triangles[t][k]]), plane.w, 0.01 * longest);
    }
}

TEST(Slivers, WithoutAnyAreaGoWithTheirNeighbors) {
    Mesh mesh = floor_with_a_lifted_vertex({0, 0, 0});
    mesh.positions[3].z = 0.1f;  // bent, so that it is not one facet
    for (const vec3& at : {vec3(0.25f, 0, 0), vec3(0), vec3(0.5f, 0, 0)}) {
        mesh.positions[1] = at;
        const auto surface = mesh.surface();
        EXPECT_EQ(surface->triangle_facet[0], surface->triangle_facet[1]);
        for (const vec4& plane : surface->facet_plane) EXPECT_NEAR(glm::length(vec3(plane)), 1.0f, 1e-5f);
    }
}

TEST(Slivers, HideNoLineBesideThem) {
    for (const float lift : {2e-3f, -2e-3f}) {
        const Mesh mesh = floor_with_a_lifted_vertex({0, 0, lift});
        for (const View& view : views_from_above()) {
            const Drawing drawing({place(mesh)}, view, {all_edges()});
            for (Index e = 0; e < drawing.scene.placements[0].surface->mesh_edges; ++e) {
                const auto length = drawing.length_of(e);
                EXPECT_NEAR(length.visible, length.all, 0.5) << e;
            }
        }
    }
}

TEST(Slivers, TellNothingAboutGrooves) {
    // A floor and a wall that leans over it, turned away from the viewer: the edge between them is hidden by the wall
    // of a solid. The wall's lowest triangle is a sliver.
    Mesh plain = of_polygons("groove", {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {1, 0.5f, 1}, {0, 0.5f, 1}},
                             {{0, 1, 2, 3}, {1, 0, 5, 4}});
    for (const float lift : {4e-3f, -4e-3f}) {
        Mesh split("groove", plain.positions);
        split.positions.push_back({0.5f, lift, 0});
        split.add_polygon({0, 6, 1, 2, 3});
        split.add_polygon({1, 6, 0, 5, 4});
        split.ngon_triangles = {{0, 1, 2}, {0, 2, 3}, {0, 6, 1}, {1, 0, 5}, {1, 5, 4}, {1, 6, 0}};
        split.ngon_polygon = {0, 0, 0, 1, 1, 1};
        for (const dvec3 eye : {dvec3(0.5, 3, 2), dvec3(0.5, -3, 2), dvec3(0.5, -3, -2), dvec3(0.5, 3, -0.5)}) {
            const View view = perspective(eye, {0.5, 0.3, 0.3});
            const auto inner_at = [&](const Mesh& mesh, const std::set<Index>& vertices) {
                const Drawing drawing({place(mesh)}, view, {all_edges()});
                const OwnSides sides = own_sides(drawing.clipped, drawing.scene, view);
                std::set<int> inner;
                for (Index i = 0; i < drawing.clipped.px.size(); ++i) {
                    const Index source = drawing.clipped.source[i];
                    const Index place = drawing.paths.place[source];
                    const auto& surface = *drawing.scene.placements[0].surface;
                    if (!surface.is_edge(place) || drawing.clipped.facet0[i] == none) continue;
                    const Edge e = surface.edges[place];
                    if (vertices.contains(e.x) && vertices.contains(e.y)) inner.insert(sides.inner[i]);
                }
                return inner;
            };
            EXPECT_EQ(inner_at(split, {0, 1, 6}), inner_at(plain, {0, 1}));
        }
    }
}
