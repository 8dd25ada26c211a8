// What is solid and what is not.
#include <gtest/gtest.h>

#include "mesh/bodies.h"
#include "meshes.h"

using namespace fovea;
using namespace fovea::meshes;

namespace {

Index closed_facets(const Surface& surface) {
    const auto found = bodies(surface);
    EXPECT_EQ(found->of_facet.size(), surface.facet_count());
    return static_cast<Index>(std::count(found->of_facet.begin(), found->of_facet.end(), 1));
}

bool all_solid(const Mesh& mesh) {
    const auto surface = mesh.surface();
    EXPECT_TRUE(closed_facets(*surface) == surface->facet_count() || !bodies(*surface)->all);
    return bodies(*surface)->all;
}

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
    EXPECT_TRUE(all_solid(box()));
    EXPECT_TRUE(all_solid(box(vec3(10, 20, 30), vec3(11, 21, 31)))) << "wherever it lies";
    EXPECT_TRUE(all_solid(tetrahedron()));
    EXPECT_TRUE(all_solid(sphere(12)));
    EXPECT_FALSE(all_solid(inside_out(box())));
    EXPECT_FALSE(all_solid(grid(4)));
    EXPECT_FALSE(all_solid(moebius(12)));
    EXPECT_FALSE(all_solid(two_boxes_at_an_edge())) << "four facets at an edge";
    EXPECT_FALSE(all_solid(Mesh("nothing", {})));
}

TEST(Bodies, AreToldApart) {
    const auto surface = with_another(box(), inside_out(box())).surface();
    EXPECT_EQ(closed_facets(*surface), 6u);
    EXPECT_TRUE(bodies(*surface)->of_facet[0]);
    EXPECT_TRUE(all_solid(with_another(box(), tetrahedron())));
}

TEST(Bodies, HideWithAllOfTheirFacets) {
    Mesh glazed = box();
    glazed.occluding.assign(6, 1);
    glazed.occluding[2] = 0;
    EXPECT_FALSE(all_solid(glazed));
}
