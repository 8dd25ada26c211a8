// SPDX-License-Identifier: GPL-3.0-or-later
// OBJ files are read as they stand; what is broken in them is left out and counted.
#include <cmath>
#include <gtest/gtest.h>
#include <tool/read_obj.h>

#include "model_files.h"
#include "refused.h"

using namespace fovea;
using namespace fovea::draw;
using namespace fovea::model_files;

namespace {

const std::string square = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";

tool::Model read(const std::string& text) { return tool::read_obj("folder/a.obj", text); }

std::vector<std::vector<int>> polygons(const tool::Model& model) {
    std::vector<std::vector<int>> found;
    for (Index f = 0; f < model.polygon_count(); ++f)
        found.emplace_back(model.corner_verts.begin() + model.polygon_offsets[f],
                           model.corner_verts.begin() + model.polygon_offsets[f + 1]);
    return found;
}

using Polygons = std::vector<std::vector<int>>;

}  // namespace

TEST(ReadObj, ACubeHasEightVerticesTwelveEdgesAndSixFacetsHoweverItsCornersAreWritten) {
    for (const char* corner : {"%", "%/1", "%//1", "%/1/1", "%/"})
        for (const char* line_end : {"\n", "\r\n", "\r", "  \n\n# text\n"}) {
            const tool::Model model = read(cube_obj(corner, line_end));
            EXPECT_EQ(model.name, "a");
            EXPECT_EQ(model.polygons.count + model.vertices.count, 0u);
            const auto surface = model.surface();
            EXPECT_EQ(surface->vertex_count(), 8u);
            EXPECT_EQ(surface->mesh_edges, 12u);
            EXPECT_EQ(surface->facet_count(), 6u);
            EXPECT_EQ(surface->triangles.size(), 12u);
            EXPECT_EQ(surface->report().inconsistent_edges, 0u);
        }
}

TEST(ReadObj, TheLastLineNeedsNoEndAndALineMayGoOnInTheNext) {
    EXPECT_EQ(polygons(read(square + "f 1 2 \\\n 3 \\\r\n 4")), (Polygons{{0, 1, 2, 3}}));
    EXPECT_EQ(polygons(read(square + "f 1 2 3\\")), (Polygons{{0, 1, 2}}));
}

TEST(ReadObj, NegativeCornersCountBackwardsFromWhereTheyStand) {
    EXPECT_EQ(polygons(read("v 0 0 0\nv 1 0 0\nv 0 1 0\nf -3 -2 -1\nv 9 9 9\nf -4 -3 -1")),
              (Polygons{{0, 1, 2}, {0, 1, 3}}));
}

TEST(ReadObj, FacesMayNameVerticesThatFollow) {
    EXPECT_EQ(polygons(read("f 1 2 3\n" + square)), (Polygons{{0, 1, 2}}));
}

TEST(ReadObj, ObjectsAndGroupsShareTheirVertices) {
    EXPECT_EQ(polygons(read("o one\ng a b\n" + square + "f 1 2 3\no two\ng\nv 5 5 5\nf 3 4 5\n")),
              (Polygons{{0, 1, 2}, {2, 3, 4}}));
}

TEST(ReadObj, FacesHaveTheMaterialNamedLast) {
    const tool::Model model =
        read(square + "f 1 2 3\nusemtl dark wood\nf 1 2 3\nusemtl  dark steel \nf 1 2 4\nusemtl dark wood\nf 2 3 4\n");
    EXPECT_EQ(model.material, (std::vector<int>{0, 1, 2, 1}));
}

TEST(ReadObj, NumbersAreReadWithSignsAndExponentsAndWhateverFollowsThem) {
    const tool::Model model = read("v +1 -2.5e1 .5 1 0.2 0.3 0.4 # red\nv 1e-400 1e400 -1e400\nf 1 1 2 # two\n");
    EXPECT_EQ(model.positions[0], vec3(1.0f, -25.0f, 0.5f));
    EXPECT_EQ(model.positions[1].x, 0.0f);
    EXPECT_TRUE(std::isinf(model.positions[1].y) && model.positions[1].z < 0.0f);
    EXPECT_EQ(polygons(model), (Polygons{{0, 0, 1}}));
}

TEST(ReadObj, BrokenFacesAreLeftOutCountedAndTheFirstIsNamed) {
    const std::string bad[] = {"f 1 2 9", "f 0 1 2", "f -9 1 2",  "f 1 2",
                               "f",       "f 1 x 3", "f 1 2 3.5", "f 1 2 99999999999999999999"};
    std::string all = square + "f 1 2 3\n";
    for (const std::string& face : bad) {
        const tool::Model model = read(square + "f 1 2 3\n" + face + "\nf 2 3 4\n");
        EXPECT_EQ(polygons(model), (Polygons{{0, 1, 2}, {1, 2, 3}})) << face;
        EXPECT_EQ(model.polygons.count, 1u) << face;
        EXPECT_EQ(model.polygons.first.find("line 6: a polygon "), 0u) << model.polygons.first;
        all += face + "\n";
    }
    EXPECT_EQ(read(all).polygons.count, std::size(bad));
}

TEST(ReadObj, ABrokenVertexKeepsItsNumberAndTheFacesAtItAreDegenerate) {
    for (const char* bad : {"v 1 2\n", "v a b c\n", "v\n", "v 1 2 3z\n"}) {
        const tool::Model model = read(square + bad + "v 2 2 0\nf 1 2 3\nf 1 2 5\nf 1 2 6\n");
        EXPECT_EQ(model.vertices.count, 1u) << bad;
        EXPECT_EQ(model.vertices.first, "line 5: a vertex has no three numbers");
        const auto surface = model.surface();
        EXPECT_EQ(surface->facet_count(), 2u);
        EXPECT_EQ(surface->report().non_finite_vertices, 1u);
        EXPECT_EQ(surface->report().degenerate_polygons, 1u);
    }
    EXPECT_EQ(read(square + "v nan 0 inf\nf 1 2 5\n").surface()->report().non_finite_vertices, 1u);
}

TEST(ReadObj, AHollowPolygonIsCutInsideItsOutline) {
    // An L: its corner 3 is hollow, and a fan from corner 0 would leave the outline.
    const auto surface = read("v 0 1 0\nv 0 0 0\nv 2 0 0\nv 2 2 0\nv 1 2 0\nv 1 1 0\nf 1 2 3 4 5 6\n").surface();
    double area = 0.0;
    for (const Triangle& t : surface->triangles)
        area += glm::length(glm::cross(surface->positions[t.y] - surface->positions[t.x],
                                       surface->positions[t.z] - surface->positions[t.x])) /
                2.0;
    EXPECT_NEAR(area, 3.0, 1e-6);
}

TEST(ReadObj, EdgesOfThreeFacesAreKept) {
    const auto surface = read(square + "v 0 0 1\nv 0 0 -1\nf 1 2 3\nf 1 2 5\nf 1 2 6\n").surface();
    EXPECT_EQ(surface->report().non_manifold_edges, 1u);
    EXPECT_EQ(surface->facet_count(), 3u);
}

TEST(ReadObj, WhatIsNoObjIsRefusedInOneSentence) {
    EXPECT_EQ(refused([] { read(""); }), "folder/a.obj, line 0: the file ends without a vertex (v X Y Z)");
    EXPECT_EQ(refused([] { read("hello\nworld"); }), "folder/a.obj, line 2: the file ends without a vertex (v X Y Z)");
    EXPECT_EQ(refused([] { read(std::string("v 0 0 0\n\0", 9)); }),
              "folder/a.obj, byte 8: this is no text, as OBJ files are");
}
