// SPDX-License-Identifier: GPL-3.0-or-later
// Broken elements are skipped and counted, never fatal; moved vertices give what a fresh surface gives.
#include <algorithm>
#include <cstring>
#include <gtest/gtest.h>
#include <limits>

#include <fovea/mesh/polygon_surface.h>

#include "meshes.h"
#include "refused.h"

using namespace fovea;
using namespace fovea::draw;
using namespace fovea::meshes;

namespace {

constexpr float not_a_number = std::numeric_limits<float>::quiet_NaN();
constexpr float inf = std::numeric_limits<float>::infinity();

/// Everything a later stage reads, compared bit for bit.
void expect_equal(const Surface& a, const Surface& b) {
    const auto same = [](const auto& x, const auto& y, const char* what) {
        ASSERT_EQ(x.size(), y.size()) << what;
        EXPECT_EQ(std::memcmp(x.data(), y.data(), x.size() * sizeof(x[0])), 0) << what;
    };
    same(a.edges, b.edges, "edges");
    same(a.positions, b.positions, "positions");
    same(a.triangles, b.triangles, "triangles");
    same(a.triangle_facet, b.triangle_facet, "triangle_facet");
    same(a.facet_plane, b.facet_plane, "facet_plane");
    same(a.facet_polygon, b.facet_polygon, "facet_polygon");
    same(a.edge_rows.offsets, b.edge_rows.offsets, "edge_rows");
    same(a.edge_sides, b.edge_sides, "edge_sides");
    EXPECT_EQ(a.occluding_triangles, b.occluding_triangles);
    EXPECT_EQ(a.center, b.center);
    EXPECT_EQ(a.radius, b.radius);
    EXPECT_EQ(std::memcmp(&a.report(), &b.report(), sizeof(SurfaceReport)), 0);
}

}  // namespace

TEST(BrokenMesh, PolygonsAtNonFiniteVerticesAreSkipped) {
    for (const float bad : {not_a_number, inf, -inf}) {
        Mesh mesh = box();
        mesh.positions[7].y = bad;
        const auto surface = mesh.surface();
        EXPECT_EQ(surface->report().non_finite_vertices, 1u);
        EXPECT_EQ(surface->report().degenerate_polygons, 3u);
        EXPECT_EQ(surface->facet_count(), 3u);
        EXPECT_EQ(surface->triangles.size(), 6u);
        EXPECT_NEAR(surface->radius, std::sqrt(3.0f), 1e-6f) << "the other vertices bound it";
    }
}

TEST(BrokenMesh, ZeroAreaIsSkipped) {
    const std::vector<vec3> p{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {0, 1, 0}, {0, 0, 0}};
    const auto surface = of_polygons("zero", p, {{0, 1, 2}, {0, 4, 1}, {0, 1, 3}}).surface();
    EXPECT_EQ(surface->report().degenerate_polygons, 2u);
    EXPECT_EQ(surface->facet_count(), 1u);
    EXPECT_EQ(surface->facet_polygon[0], 2u) << "polygons keep their numbers";
}

TEST(BrokenMesh, TwoCornersOrOneTwiceAreNoPolygon) {
    const std::vector<vec3> p{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
    const auto surface = of_polygons("few", p, {{0, 1}, {0}, {}, {0, 0, 1}, {0, 1, 2}}).surface();
    EXPECT_EQ(surface->polygon_count(), 5u);
    EXPECT_EQ(surface->report().degenerate_polygons, 4u);
    EXPECT_EQ(surface->facet_count(), 1u);
}

TEST(BrokenMesh, SmallAndLargeMeshesAreNotDegenerate) {
    for (const float scale : {1e-15f, 1e-6f, 1e6f, 1e15f}) {
        const auto surface = box(vec3(-scale), vec3(scale)).surface();
        EXPECT_EQ(surface->report().degenerate_polygons, 0u);
        EXPECT_EQ(surface->facet_count(), 6u) << "flat polygons stay flat at " << scale;
        EXPECT_EQ(surface->edges.size(), 12u);
    }
}

TEST(BrokenMesh, DuplicateFacesCountOnce) {
    Mesh mesh = box();
    mesh.add_polygon({0, 1, 5, 4});  // face 2 as it is
    mesh.add_polygon({4, 5, 1, 0});  // and turned around
    mesh.add_polygon({5, 4, 0, 1});  // and from another corner
    const auto surface = mesh.surface();
    EXPECT_EQ(surface->report().duplicate_polygons, 3u);
    EXPECT_EQ(surface->facet_count(), 6u);
    EXPECT_EQ(surface->report().non_manifold_edges, 0u);
    for (Index e = 0; e < 12; ++e) EXPECT_EQ(surface->edge_rows.size(e), 2u);
}

TEST(BrokenMesh, TheSameVerticesInAnotherOrderAreADuplicate) {
    // The second polygon crosses itself.
    const auto surface =
        of_polygons("crossed", {{0, 0, 0}, {2, 0, 0}, {2, 2, 0}, {0.5f, 1, 0}}, {{0, 1, 2, 3}, {0, 1, 3, 2}}).surface();
    EXPECT_EQ(surface->report().duplicate_polygons, 1u);
    EXPECT_EQ(surface->facet_polygon[0], 0u);
}

TEST(BrokenMesh, ThousandsOfDuplicatesAreFoundQuickly) {
    Mesh mesh("stack", {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}});
    for (int i = 0; i < 20000; ++i) mesh.add_polygon({0, 1, 2});
    const auto surface = mesh.surface();
    EXPECT_EQ(surface->report().duplicate_polygons, 19999u);
    EXPECT_EQ(surface->facet_count(), 1u);
}

TEST(BrokenMesh, LooseEdgesAreCounted) {
    Mesh mesh = box();
    mesh.positions.push_back({5, 5, 5});
    mesh.edge(0, 8);
    mesh.edge(7, 0);
    const auto surface = mesh.surface();
    EXPECT_EQ(surface->report().loose_edges, 2u);
    EXPECT_EQ(surface->mesh_edges, 14u);
    EXPECT_EQ(surface->edge_rows.size(12), 0u);
}

TEST(BrokenMesh, EdgesOfAPolygonThatIsSkippedKeepTheirOtherSide) {
    Mesh mesh = box();
    mesh.positions[7] = mesh.positions[3] = vec3(not_a_number);
    const auto surface = mesh.surface();
    for (Index e = 0; e < surface->mesh_edges; ++e)
        for (Index i = surface->edge_rows.begin(e); i < surface->edge_rows.end(e); ++i)
            EXPECT_LT(surface->edge_sides[i].facet(), surface->facet_count());
    EXPECT_EQ(surface->edge_sides.size(), 4u * surface->facet_count());
}

TEST(BrokenMesh, CornersAndEdgesThatContradictEachOtherDoNotCrash) {
    Mesh mesh = box();
    std::reverse(mesh.corner_edges.begin(), mesh.corner_edges.end());
    const auto surface = mesh.surface();
    EXPECT_EQ(surface->facet_count(), 6u);
    Mesh bent = bent_quad();
    bent.ngon_triangles = {{0, 1, 3}};  // not asked of a quad
    bent.ngon_polygon = {0};
    EXPECT_EQ(bent.surface()->triangles.size(), 2u);
}

TEST(BrokenMesh, TriangulationsThatBelongToOtherVerticesDoNotCrash) {
    Mesh mesh = l_shape();
    mesh.positions[3].z = 0.5f;
    mesh.ngon_triangles = {{0, 0, 0}, {0, 1, 2}, {2, 1, 0}, {5, 5, 1}};
    EXPECT_EQ(mesh.surface()->triangles.size(), 4u);
}

TEST(BrokenMesh, AnEdgeOfOtherVerticesThanItsPolygonNamesHasNoSideThere) {
    Mesh mesh = box();
    mesh.positions.push_back(vec3(not_a_number));
    mesh.edge_verts[3].y = 8;  // two polygons name it
    const auto surface = mesh.surface();
    EXPECT_EQ(surface->facet_count(), 6u);
    EXPECT_EQ(surface->report().loose_edges, 1u);
    EXPECT_TRUE(surface->is_loose(11)) << "it is the last one";
    EXPECT_EQ(surface->edges[11].y, 8u);
    for (Index e = 0; e < 12; ++e) EXPECT_EQ(surface->edge_rows.size(e), e < 11 ? 2u : 0u);
}

TEST(BrokenMesh, ATriangulationOfOtherVerticesThanItsPolygonsIsNotUsed) {
    Mesh mesh = l_shape();
    mesh.positions[3].z = 0.5f;
    mesh.positions.push_back(vec3(not_a_number));
    mesh.ngon_triangles[1] = {1, 2, 6};
    const auto surface = mesh.surface();
    ASSERT_EQ(surface->triangles.size(), 4u);
    for (const Triangle& t : surface->triangles)
        for (int i = 0; i < 3; ++i) EXPECT_LT(t[i], 6u);
}

TEST(BrokenMesh, PlainPolygonsThatNameAVertexThatIsNotThereAreRefusedBeforeTheyAreCut) {
    const std::vector<vec3> positions(5, vec3(0.0f));
    const std::vector<int> offsets{0, 6};
    for (const int wrong : {-1, 5, 1 << 30}) {
        const std::vector<int> corners{0, 1, 2, wrong, 3, 4};
        const std::string sentence = refused([&] { polygon_surface("Kite", positions, corners, offsets); });
        EXPECT_EQ(sentence.substr(0, 6), "Kite: ") << sentence;
    }
    const std::vector<int> corners{0, 1, 2, 3, 4, 0};
    EXPECT_EQ(refused([&] { polygon_surface("Kite", positions, corners, std::vector<int>{0, 7}); }),
              "Kite: polygon_offsets must ascend and stay within corner_verts; the mesh is broken (Mesh > Validate "
              "mends it)");
}

TEST(BrokenMesh, TenThousandCornersWithAndWithoutTriangulation) {
    Mesh mesh("disc", {});
    std::vector<int> polygon;
    const int n = 10000;
    for (int i = 0; i < n; ++i) {
        const double a = 2.0 * std::numbers::pi * i / n;
        mesh.positions.push_back(vec3(dvec3(std::cos(a), std::sin(a), 0)));
        polygon.push_back(i);
    }
    mesh.add_polygon(polygon);
    EXPECT_EQ(mesh.surface()->triangles.size(), n - 2u);
    EXPECT_EQ(mesh.surface()->facet_count(), 1u);
    for (int i = 1; i + 1 < n; ++i) {
        mesh.ngon_triangles.push_back({i, i + 1, 0});
        mesh.ngon_polygon.push_back(0);
    }
    for (int i = 0; i < n; ++i) mesh.positions[i].z = 0.2f * (i % 2);  // bent
    const auto bent = mesh.surface();
    EXPECT_GT(bent->facet_count(), n - 10u) << "every triangle for itself, without slivers at the middle of the fan";
    EXPECT_EQ(bent->edges.size(), n + bent->facet_count() - 1u);
}

TEST(SetPositions, EqualsAFreshSurface) {
    Mesh mesh = two_boxes_at_an_edge();
    mesh.occluding.assign(12, 1);
    mesh.occluding[4] = 0;
    const auto moved = mesh.surface();
    const std::uint64_t before = moved->version();
    const std::vector<vec3> first = mesh.positions;
    // Bend, break, and mend again: as many diagonals and skipped polygons come and go.
    const auto bend = [](std::vector<vec3>& p) { p[3].z += 0.4f, p[0] *= 1.5f; };
    const auto spoil = [](std::vector<vec3>& p) { p[5].x = not_a_number, p[9] = p[10]; };
    for (int step = 0; step < 3; ++step) {
        mesh.positions = first;
        if (step == 0) bend(mesh.positions);
        if (step == 1) spoil(mesh.positions);
        moved->set_positions(mesh.positions);
        expect_equal(*moved, *mesh.surface());
    }
    EXPECT_NE(moved->version(), before);
}
