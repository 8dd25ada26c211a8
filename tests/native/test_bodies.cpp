// SPDX-License-Identifier: GPL-3.0-or-later
// What is solid and what is not.
#include <gtest/gtest.h>

#include <fovea/scene/bodies.h>

#include "meshes.h"

using namespace fovea;
using namespace fovea::draw;
using namespace fovea::meshes;

namespace {

bool all_outward(const Mesh& mesh) { return bodies_of(*mesh.surface())->all_outward; }

/// The box, and another to its right.
Mesh with_another(const Mesh& first, const Mesh& second) {
    std::vector<vec3> positions = first.positions;
    Polygons polygons;
    for (const auto& [mesh, base] : {std::pair(&first, 0), std::pair(&second, int(first.positions.size()))}) {
        if (base > 0)
            for (const vec3& p : mesh->positions) positions.push_back(p + vec3(5, 0, 0));
        for (std::size_t f = 0; f + 1 < mesh->polygon_offsets.size(); ++f) {
            polygons.push_back({});
            for (int c = mesh->polygon_offsets[f]; c < mesh->polygon_offsets[f + 1]; ++c)
                polygons.back().push_back(mesh->corner_verts[c] + base);
        }
    }
    return of_polygons("two", positions, polygons);
}

Mesh inside_out(Mesh mesh) {
    Polygons polygons;
    for (std::size_t f = 0; f + 1 < mesh.polygon_offsets.size(); ++f) {
        polygons.emplace_back(mesh.corner_verts.begin() + mesh.polygon_offsets[f],
                              mesh.corner_verts.begin() + mesh.polygon_offsets[f + 1]);
        std::reverse(polygons.back().begin(), polygons.back().end());
    }
    return of_polygons("inside out", mesh.positions, polygons);
}

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
    EXPECT_FALSE(found->all_outward);
    EXPECT_TRUE(all_outward(with_another(box(), tetrahedron())));
}

TEST(Bodies, HideWithAllOfTheirFacets) {
    Mesh glazed = box();
    glazed.occluding.assign(6, 1);
    glazed.occluding[2] = 0;
    EXPECT_FALSE(all_outward(glazed));
}
