// SPDX-License-Identifier: GPL-3.0-or-later
// What is solid and what is not.
#include <gtest/gtest.h>

#include <fovea/scene/bodies.h>

#include "meshes.h"

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

TEST(Bodies, HideWithAllOfTheirFacets) {
    Mesh glazed = box();
    glazed.occluding.assign(6, 1);
    glazed.occluding[2] = 0;
    EXPECT_FALSE(all_outward(glazed));
}
