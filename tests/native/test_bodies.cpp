// SPDX-License-Identifier: GPL-3.0-or-later
// What is solid and what is not.
#include <gtest/gtest.h>

#include <fovea/scene/bodies.h>

#include "intersections.h"

using namespace fovea;
using namespace fovea::draw;
using namespace fovea::meshes;

namespace {

Mesh inside_out(const Mesh& mesh) {
    return flipped(mesh, [](int) { return true; });
}

bool all_outward(const Mesh& mesh) { return bodies_of(*mesh.surface())->all_outward; }

}  // namespace

TEST(Bodies, AreClosedAndFaceOutwards) {
    EXPECT_TRUE(all_outward(box()));
    EXPECT_TRUE(all_outward(box(vec3(10, 20, 30), vec3(11, 21, 31)))) << "wherever it lies";
    EXPECT_TRUE(all_outward(tetrahedron()));
    EXPECT_TRUE(all_outward(sphere(12)));
    EXPECT_FALSE(all_outward(inside_out(box())));
    EXPECT_FALSE(all_outward(grid(4)));
    EXPECT_FALSE(all_outward(moebius(12)));
    EXPECT_TRUE(all_outward(two_boxes_at_an_edge())) << "four facets at an edge, two each way";
    EXPECT_FALSE(all_outward(Mesh("nothing", {})));
}

TEST(Bodies, AreToldApart) {
    const auto found = bodies_of(*with_another(box(), inside_out(box())).surface());
    ASSERT_EQ(found->solid.size(), 2u);
    EXPECT_TRUE(found->solid[0] && found->solid[1]) << "whichever side is out";
    EXPECT_NE(found->of_facet.front(), found->of_facet.back());
    EXPECT_TRUE(found->outward[0] && !found->outward[1] && !found->all_outward);
    EXPECT_TRUE(all_outward(with_another(box(), tetrahedron())));
}

TEST(Bodies, GoOnWhereTheirVerticesAreSplit) {
    const auto found =
        bodies_of(*intersections::split(with_another(box(), inside_out(box(vec3(2), vec3(3))))).surface());
    ASSERT_EQ(found->solid.size(), 2u) << "each face has vertices of its own";
    EXPECT_TRUE(found->outward[0] && found->solid[1] && !found->outward[1]);
    EXPECT_FALSE(all_outward(intersections::split(grid(4)))) << "open, with or without seams";
    EXPECT_FALSE(all_outward(intersections::split(moebius(12))));
    Mesh pyramid("pyramid", {{-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0}, {0, 0, 1}, {0, 0, 1}});
    for (int i = 0; i < 4; ++i) pyramid.add_polygon({i, (i + 1) % 4, 4, 5});
    pyramid.add_polygon({3, 2, 1, 0});
    EXPECT_TRUE(all_outward(intersections::split(pyramid))) << "edges of no length are no gaps";
    Mesh lidless = intersections::split(box());
    lidless.occluding = {1, 1, 1, 1, 1, 0};
    EXPECT_FALSE(all_outward(lidless));
    Mesh moved = intersections::split(box());
    moved.positions[0].x -= 1e-3f;
    EXPECT_FALSE(all_outward(moved)) << "a gap, however narrow";
}

TEST(Bodies, HideWithAllOfTheirFacets) {
    Mesh glazed = box();
    glazed.occluding.assign(6, 1);
    glazed.occluding[2] = 0;
    EXPECT_FALSE(all_outward(glazed));
}
