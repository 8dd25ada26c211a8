// SPDX-License-Identifier: GPL-3.0-or-later
// Topology of surfaces: edge table, facets, marks, what is refused.
#include <algorithm>
#include <gtest/gtest.h>
#include <numeric>
#include <random>

#include <fovea/mesh/polygon_surface.h>
#include <fovea/mesh/surface.h>

#include "meshes.h"

using namespace fovea;
using namespace fovea::draw;
using namespace fovea::meshes;

namespace {

/// The message of the std::invalid_argument that building the mesh throws.
std::string refusal(const Mesh& mesh) {
    try {
        mesh.surface();
    } catch (const std::invalid_argument& error) {
        return error.what();
    }
    return "accepted";
}

}  // namespace

TEST(Surface, EveryEdgeOfABoxHasTwoOpposedSides) {
    const auto surface = box().surface();
    EXPECT_EQ(surface->mesh_edges, 12u);
    EXPECT_EQ(surface->edges.size(), 12u);
    EXPECT_EQ(surface->facet_count(), 6u);
    EXPECT_EQ(surface->triangles.size(), 12u);
    EXPECT_EQ(surface->occluding_triangles, 12u);
    for (Index e = 0; e < 12; ++e) {
        ASSERT_EQ(surface->edge_rows.size(e), 2u);
        const EdgeSide a = surface->edge_sides[surface->edge_rows.begin(e)];
        const EdgeSide b = surface->edge_sides[surface->edge_rows.begin(e) + 1];
        EXPECT_NE(a.facet(), b.facet());
        EXPECT_NE(a.forward(), b.forward());
    }
    EXPECT_EQ(surface->center, vec3(0));
    EXPECT_NEAR(surface->radius, std::sqrt(3.0f), 1e-6f);
}

TEST(Surface, FacetPlanesPointOutwards) {
    const auto surface = box().surface();
    for (Index f = 0; f < surface->facet_count(); ++f) {
        const vec4 plane = surface->facet_plane[f];
        EXPECT_NEAR(glm::length(vec3(plane)), 1.0f, 1e-6f);
        EXPECT_NEAR(plane.w, 1.0f, 1e-6f) << "the origin lies one unit inside each face";
    }
}

TEST(Surface, ForwardMeansAlongTheEdge) {
    // The triangle runs 0 -> 1 -> 2; its edges are stored as (2,0), (0,1), (1,2).
    const auto surface = of_polygons("triangle", {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}}).surface();
    for (Index e = 0; e < 3; ++e) EXPECT_TRUE(surface->edge_sides[surface->edge_rows.begin(e)].forward());
    Mesh turned("triangle", {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}});
    turned.edge(1, 0);
    turned.add_polygon({0, 1, 2});
    EXPECT_FALSE(turned.surface()->sides(1)[0].forward());
}

TEST(Surface, OnlyBentPolygonsHaveDiagonals) {
    EXPECT_EQ(grid(3).surface()->edges.size(), 24u) << "flat quads: mesh edges only";
    const auto flat_ngon = l_shape().surface();
    EXPECT_EQ(flat_ngon->edges.size(), 6u);
    EXPECT_EQ(flat_ngon->facet_count(), 1u);
    EXPECT_EQ(flat_ngon->triangles.size(), 4u);

    const auto bent = bent_quad().surface();
    ASSERT_EQ(bent->edges.size(), 5u);
    EXPECT_EQ(bent->mesh_edges, 4u);
    EXPECT_EQ(bent->facet_count(), 2u);
    const Edge diagonal = bent->edges[4];
    EXPECT_EQ(std::min(diagonal.x, diagonal.y), 0u);
    EXPECT_EQ(std::max(diagonal.x, diagonal.y), 2u);
    ASSERT_EQ(bent->edge_rows.size(4), 2u);
    const EdgeSide a = bent->edge_sides[bent->edge_rows.begin(4)], b = bent->edge_sides[bent->edge_rows.begin(4) + 1];
    EXPECT_NE(a.facet(), b.facet());
    EXPECT_NE(a.forward(), b.forward());
}

TEST(Surface, FlatToATenthOfADegree) {
    EXPECT_EQ(bent_quad(0.0005f).surface()->facet_count(), 1u);
    EXPECT_EQ(bent_quad(0.02f).surface()->facet_count(), 2u);
}

TEST(Surface, SidesOfABentNgonBelongToTheTriangleThatHoldsThem) {
    Mesh mesh = l_shape();
    mesh.positions[2].z = 1.0f;  // only the triangle 1-2-3 leaves the plane
    const auto surface = mesh.surface();
    EXPECT_EQ(surface->facet_count(), 4u);
    EXPECT_EQ(surface->edges.size(), 6u + 3u) << "three diagonals";
    for (Index e = 0; e < 6; ++e) {
        ASSERT_EQ(surface->edge_rows.size(e), 1u);
        const Index facet = surface->edge_sides[surface->edge_rows.begin(e)].facet();
        const vec4 plane = surface->facet_plane[facet];
        for (int end = 0; end < 2; ++end)
            EXPECT_NEAR(glm::dot(vec3(plane), surface->positions[surface->edges[e][end]]), plane.w, 1e-5f)
                << "both ends of edge " << e << " lie in its facet's plane";
    }
}

TEST(Surface, SidesOfABentQuadBelongToTheTriangleThatHoldsThemHoweverItIsSplit) {
    Mesh concave = concave_quad();
    concave.positions[1].z += 0.7f;
    for (const Mesh& quad : {bent_quad(), concave})
        for (int first = 0; first < 4; ++first) {
            const auto at = [&](int i) { return (first + i) % 4; };
            const auto surface = of_polygons(quad.name, quad.positions, {{at(0), at(1), at(2), at(3)}}).surface();
            ASSERT_EQ(surface->facet_count(), 2u);
            ASSERT_EQ(surface->edges.size(), 5u);
            ASSERT_EQ(surface->edge_rows.size(4), 2u) << "the diagonal";
            for (Index e = 0; e < 5; ++e)
                for (const EdgeSide side : surface->sides(e)) {
                    const Edge edge = surface->edges[e];
                    const Edge along = side.forward() ? edge : Edge(edge.y, edge.x);
                    const Triangle& t = surface->triangles[side.facet()];  // each is a facet
                    EXPECT_EQ(surface->triangle_facet[side.facet()], side.facet());
                    EXPECT_TRUE(along == Edge(t.x, t.y) || along == Edge(t.y, t.z) || along == Edge(t.z, t.x))
                        << quad.name << " from corner " << first << ", edge " << e;
                }
        }
}

TEST(Surface, ConcaveQuadsAreSplitInside) {
    for (const float scale : {1.0f, 1e-12f, 1e12f}) {
        Mesh mesh = concave_quad();
        for (vec3& p : mesh.positions) p *= scale;
        const auto surface = mesh.surface();
        ASSERT_EQ(surface->triangles.size(), 2u);
        for (const Triangle& t : surface->triangles) {
            const dvec3 a(surface->positions[t.x]), b(surface->positions[t.y]), c(surface->positions[t.z]);
            EXPECT_GT(glm::cross(b - a, c - a).z, 0.0) << "both halves face up at scale " << scale;
        }
    }
}

TEST(Surface, MarksAreBits) {
    Mesh mesh = box();
    mesh.sharp = mesh.edge_flags({0, 1});
    mesh.seam = mesh.edge_flags({1, 2});
    mesh.edge_mark = mesh.edge_flags({1, 3});
    const auto surface = mesh.surface();
    EXPECT_EQ(surface->edge_marks[0], mark_sharp);
    EXPECT_EQ(surface->edge_marks[1], mark_sharp | mark_seam | mark_edge);
    EXPECT_EQ(surface->edge_marks[2], mark_seam);
    EXPECT_EQ(surface->edge_marks[3], mark_edge);
    EXPECT_EQ(surface->edge_marks[4], 0);
}

TEST(Surface, EdgesAreNumberedByThePolygonsInWhateverOrderAMeshHasThem) {
    std::mt19937 random(5);
    Mesh mesh = sphere(12);
    mesh.edge(0, 40);  // without a polygon
    for (std::size_t e = 0; e < mesh.edge_verts.size(); ++e) {
        mesh.sharp.push_back(random() % 2);
        mesh.seam.push_back(random() % 2);
    }
    Mesh mixed = mesh;
    std::vector<int> place(mesh.edge_verts.size());
    std::iota(place.begin(), place.end(), 0);
    std::shuffle(place.begin(), place.end(), random);
    for (std::size_t e = 0; e < place.size(); ++e) {
        mixed.edge_verts[place[e]] = mesh.edge_verts[e];
        mixed.sharp[place[e]] = mesh.sharp[e];
        mixed.seam[place[e]] = mesh.seam[e];
    }
    for (int& edge : mixed.corner_edges) edge = place[edge];
    const auto one = mesh.surface(), other = mixed.surface();
    EXPECT_EQ(one->edges, other->edges);
    EXPECT_EQ(one->edge_marks, other->edge_marks);
    EXPECT_TRUE(std::ranges::equal(one->edge_sides, other->edge_sides, {}, &EdgeSide::packed, &EdgeSide::packed));
    EXPECT_EQ(one->edges.back(), Edge(0, 40));
    EXPECT_EQ(one->report().loose_edges, 1u);
}

TEST(Surface, OccludingTrianglesComeFirst) {
    Mesh mesh = grid(2);
    mesh.occluding = {0, 1, 0, 1};
    const auto surface = mesh.surface();
    EXPECT_EQ(surface->occluding_triangles, 4u);
    EXPECT_EQ(surface->triangles.size(), 8u);
    for (Index t = 0; t < 8; ++t) {
        const Index polygon = surface->facet_polygon[surface->triangle_facet[t]];
        EXPECT_EQ(mesh.occluding[polygon] != 0, t < 4);
    }
}

TEST(Surface, TwoBoxesShareAnEdgeOfFourSides) {
    const auto surface = two_boxes_at_an_edge().surface();
    EXPECT_EQ(surface->mesh_edges, 23u);
    EXPECT_EQ(surface->report().non_manifold_edges, 1u);
    int four = 0;
    for (Index e = 0; e < surface->mesh_edges; ++e) four += surface->edge_rows.size(e) == 4;
    EXPECT_EQ(four, 1);
}

TEST(Surface, AMoebiusStripDisagreesOnce) {
    EXPECT_EQ(moebius(24).surface()->report().inconsistent_edges, 1u);
    EXPECT_EQ(cylinder(24).surface()->report().inconsistent_edges, 0u);
}

TEST(Surface, NothingIsASurfaceToo) {
    EXPECT_EQ(Mesh("nothing", {}).surface()->facet_count(), 0u);
    const auto point = Mesh("point", {{1, 2, 3}}).surface();
    EXPECT_EQ(point->vertex_count(), 1u);
    EXPECT_EQ(point->center, vec3(1, 2, 3));
    Mesh no_offsets("no offsets", {{1, 2, 3}});
    no_offsets.polygon_offsets.clear();
    EXPECT_EQ(no_offsets.surface()->polygon_count(), 0u);
}

TEST(Surface, RefusesWhatDoesNotFitTogether) {
    EXPECT_EQ(refusal(box()), "accepted");
    const auto broken = [](auto&& spoil) {
        Mesh mesh = box();
        spoil(mesh);
        return refusal(mesh);
    };
    const std::string messages[] = {
        broken([](Mesh& m) { m.corner_verts[5] = 8; }),
        broken([](Mesh& m) { m.corner_verts[5] = -1; }),
        broken([](Mesh& m) { m.corner_edges[5] = 12; }),
        broken([](Mesh& m) { m.corner_edges.pop_back(); }),
        broken([](Mesh& m) { m.edge_verts[3].y = 8; }),
        broken([](Mesh& m) { m.edge_verts[3].x = -7; }),
        broken([](Mesh& m) { m.positions.pop_back(); }),
        broken([](Mesh& m) { m.polygon_offsets = {0, 4, 30, 12, 16, 20, 24}; }),
        broken([](Mesh& m) { m.polygon_offsets = {0, 4}; }),
        broken([](Mesh& m) { m.polygon_offsets = {4, 24}; }),
        broken([](Mesh& m) { m.polygon_offsets = {-4, 24}; }),
        broken([](Mesh& m) { m.material = {1}; }),
        broken([](Mesh& m) { m.occluding = {1, 1}; }),
        broken([](Mesh& m) { m.sharp = {1}; }),
        broken([](Mesh& m) { m.seam = {1}; }),
        broken([](Mesh& m) { m.edge_mark.assign(13, 1); }),
        broken([](Mesh& m) { m.ngon_triangles = {{0, 1, 8}}, m.ngon_polygon = {0}; }),
        broken([](Mesh& m) { m.ngon_triangles = {{0, 1, 2}}, m.ngon_polygon = {6}; }),
        broken([](Mesh& m) { m.ngon_triangles = {{0, 1, 2}}, m.ngon_polygon = {}; }),
        broken([](Mesh& m) { m.ngon_triangles.assign(2, {0, 1, 2}), m.ngon_polygon = {1, 0}; }),
    };
    for (const std::string& message : messages) EXPECT_EQ(message.rfind("box: ", 0), 0u) << message;
    const auto surface = box().surface();
    EXPECT_THROW(surface->set_positions(std::vector<vec3>(7)), std::invalid_argument);
}

TEST(PolygonEdges, AreNumberedByFirstAppearance) {
    const std::vector<int> offsets{0, 3, 6}, verts{0, 1, 2, 2, 1, 3};
    const PolygonEdges found = polygon_edges(offsets, verts);
    ASSERT_EQ(found.edge_verts.size(), 5u);
    EXPECT_EQ(found.edge_verts[1], glm::ivec2(1, 2));
    EXPECT_EQ(found.corner_edges[3], 1) << "2-1 is 1-2 again";
    EXPECT_TRUE(polygon_edges({}, {}).edge_verts.empty());
}

TEST(PolygonEdges, RefusesOffsetsThatLeaveTheCorners) {
    const std::vector<int> verts{0, 1, 2};
    for (const std::vector<int>& offsets : {std::vector<int>{0, 100, 3}, {-5, 3}, {0, 4}})
        EXPECT_THROW(polygon_edges(offsets, verts), std::invalid_argument);
}
