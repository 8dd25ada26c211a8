// SPDX-License-Identifier: GPL-3.0-or-later
// Surfaces whose backs are not seen.
#include <gtest/gtest.h>

#include <fovea/visibility/depth.h>

#include "wires.h"

using namespace fovea;
using namespace fovea::draw;
using namespace fovea::meshes;
using namespace fovea::drawing;
using namespace fovea::wires;

namespace {

Mesh one_sided(Mesh mesh) {
    mesh.one_sided.assign(mesh.polygon_offsets.size() - 1, 1);
    return mesh;
}

/// The sphere seen from its inside.
Mesh inverted(int n) {
    return one_sided(flipped(sphere(n), [](int) { return true; }));
}

bool hidden(const View& view, const Mesh& by, const dmat4& at) {
    const Wires wires({{dvec3(-0.2, 0.01, -3), dvec3(0.2, 0.02, -3)}}, dmat4(1.0), {place(by, at)});
    const ClippedPaths clipped = wires.project(view);
    const Tracer tracer(wires.scene, view);
    const bool exact = exact_visibility(clipped, wires.paths, tracer, Cancel()).piece.empty();
    const DepthBuffer depth = draw_depth(depth_layout(view, {}), view, depth_meshes(wires.scene, view, 0.1));
    const bool drawn = depth.at(depth.width / 2, depth.height / 2).facet != none;
    EXPECT_EQ(exact, drawn) << "rays and the depth buffer agree";
    return exact;
}

const View above = perspective({0, 0, 4}, {0, 0, 0}), ortho = orthographic({0, 0, 4}, {0, 0, 0}, 4);

}  // namespace

TEST(OneSided, ABackHidesNothingAndAFrontDoes) {
    const dmat4 upright(1.0), turned = glm::rotate(upright, 3.0, dvec3(1, 0, 0));
    const dmat4 mirrored = glm::scale(upright, dvec3(-1, 1, 1));
    for (const View& view : {above, ortho}) {
        EXPECT_TRUE(hidden(view, one_sided(grid(3)), upright));
        EXPECT_FALSE(hidden(view, one_sided(grid(3)), turned));
        EXPECT_TRUE(hidden(view, grid(3), turned));
        EXPECT_TRUE(hidden(view, one_sided(grid(3)), mirrored)) << "a mirrored front is a front";
    }
}

TEST(OneSided, ABackHasNoLinesOnIt) {
    const Drawing front({place(one_sided(grid(2)))}, above, {all_edges()});
    EXPECT_EQ(front.visible_edges().size(), 4u) << "those between two faces";
    const Drawing back({place(one_sided(grid(2)), glm::rotate(dmat4(1.0), 3.0, dvec3(1, 0, 0)))}, above, {all_edges()});
    EXPECT_EQ(back.clipped.path.size(), 0u);
    const Drawing box_inside({place(one_sided(flipped(box(), [](int) { return true; })))},
                             perspective({4, -5, 3}, {0, 0, 0}), {all_edges()});
    EXPECT_EQ(box_inside.visible_edges().size(), 9u) << "through the near sides one sees the edges of the far ones";
}

TEST(OneSided, AnInvertedHullSurroundsWhatItEncloses) {
    // Of the hull, its far half is seen, around the ball: the ball's own outline is whole.
    const View view = perspective({0, -6, 0}, {0, 0, 0});
    const Drawing drawing({place(sphere(24), dmat4(1.0), 1), place(inverted(24), scaled(dvec3(1.1)), 2)}, view,
                          {line_set({"contour"})});
    EXPECT_GT(drawing.total_px(0), 0.0);
    EXPECT_NEAR(drawing.visible_px(0), drawing.total_px(0), 1e-6);
    EXPECT_NEAR(drawing.visible_px(1), drawing.total_px(1), 0.01 * drawing.total_px(1));
}

TEST(OneSided, OccludingTrianglesStandInTheOrderTwoSidedThenOneSided) {
    Mesh mesh = grid(3);
    mesh.one_sided = {1, 0, 1, 0, 0, 1, 0, 0, 0};
    mesh.occluding = {1, 1, 0, 1, 0, 1, 1, 1, 1};
    const auto surface = mesh.surface();
    EXPECT_EQ(surface->two_sided_triangles, 10u);
    EXPECT_EQ(surface->occluding_triangles, 14u);
    for (Index t = 0; t < 18; ++t) {
        const Index polygon = surface->facet_polygon[surface->triangle_facet[t]];
        EXPECT_EQ(mesh.occluding[polygon] != 0, t < 14);
        if (t < 14) {
            EXPECT_EQ(mesh.one_sided[polygon] == 0, t < 10);
        }
    }
}
