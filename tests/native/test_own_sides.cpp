// SPDX-License-Identifier: GPL-3.0-or-later
// What the facets at a line's own edge tell, and what sampled visibility makes of it.
#include <gtest/gtest.h>
#include <set>

#include <fovea/visibility/own_sides.h>
#include <fovea/visibility/sampled.h>

#include "drawing.h"

using namespace fovea;
using namespace fovea::draw;
using namespace fovea::drawing;

namespace {

const dvec3 corner_eye(5, -7, 4);

/// Every edge of a mesh as a line.
struct Seen {
    Drawing drawing;
    OwnSides sides;
    Seen(const meshes::Mesh& mesh, const View& view, std::uint8_t usage = usage_draw | usage_occlude)
        : drawing({place(mesh, dmat4(1.0), 1, usage)}, view, {line_set({"contour", "crease", "border"})}),
          sides(own_sides(drawing.clipped, drawing.scene, drawing.view)) {}

    /// Edges of inner segments.
    std::set<Index> inner() const {
        std::set<Index> edges;
        const ClippedPaths& clipped = drawing.clipped;
        for (Index i = 0; i < clipped.px.size(); ++i)
            if (sides.inner[i]) edges.insert(drawing.paths.place[clipped.source[i]]);
        return edges;
    }

    /// Share of samples on which looking into a depth buffer agrees with rays.
    double agreement() const {
        const DepthOptions options;
        const DepthBuffer buffer = draw_depth(depth_layout(drawing.view, options), drawing.view,
                                              depth_meshes(drawing.scene, drawing.view, options.margin));
        const Array<float> looked = sampled_visibility(drawing.clipped, sides, buffer, {});
        const Array<float> exact = samples_from_runs(drawing.clipped, drawing.runs);
        double same = 0.0;
        for (std::size_t s = 0; s < looked.size(); ++s) same += (looked[s] >= 0.5f) == (exact[s] >= 0.5f);
        return same / double(looked.size());
    }
};

}  // namespace

TEST(OwnSides, TheThreeEdgesAtABoxesBackCornerAreInner) {
    for (const View& view : {perspective(corner_eye, dvec3(0)), orthographic(corner_eye, dvec3(0), 6.0)}) {
        const Seen box(meshes::box(), view);
        EXPECT_EQ(box.inner().size(), 3u);
        const std::set<Index> visible = box.drawing.visible_edges();
        EXPECT_EQ(visible.size(), 9u);
        for (const Index edge : box.inner()) EXPECT_FALSE(visible.contains(edge));
        EXPECT_GT(box.agreement(), 0.995);
    }
}

TEST(OwnSides, AMirroredBoxIsSeenLikeABox) {
    Drawing drawing({place(meshes::box(), scaled(dvec3(-1, 1, 1)))}, perspective(corner_eye, dvec3(0)),
                    {line_set({"contour", "crease"})});
    const OwnSides sides = own_sides(drawing.clipped, drawing.scene, drawing.view);
    std::set<Index> inner;
    for (Index i = 0; i < drawing.clipped.px.size(); ++i)
        if (sides.inner[i]) inner.insert(drawing.paths.place[drawing.clipped.source[i]]);
    EXPECT_EQ(inner.size(), 3u);
}

TEST(OwnSides, AGrooveIsInnerWhereItIsAContourAndNotWhereBothSidesShow) {
    // Two quads that meet along x: a roof or, seen from below its ridge, a gutter; outward is up.
    const auto gutter = [](float rise) {
        return meshes::of_polygons("gutter",
                                   {{-1, 0, 0}, {1, 0, 0}, {1, -1, rise}, {-1, -1, rise}, {1, 1, rise}, {-1, 1, rise}},
                                   {{0, 3, 2, 1}, {0, 1, 4, 5}});
    };
    const View above = perspective(dvec3(0, -3, 6), dvec3(0)), level = perspective(dvec3(0, -6, 0.5), dvec3(0));
    EXPECT_TRUE(Seen(gutter(0.5f), above).inner().empty());
    EXPECT_TRUE(Seen(gutter(-0.5f), above).inner().empty());
    EXPECT_EQ(Seen(gutter(0.5f), level).inner().size(), 1u);
    EXPECT_TRUE(Seen(gutter(-0.5f), level).inner().empty());
}

TEST(OwnSides, AnOpenSheetShowsItsInnerLinesWhereItsBackIsSeen) {
    const auto roof =
        meshes::of_polygons("roof", {{-1, 0, 0}, {1, 0, 0}, {1, -1, -1}, {-1, -1, -1}, {1, 1, -1}, {-1, 1, -1}},
                            {{0, 3, 2, 1}, {0, 1, 4, 5}});
    const Seen from_below(roof, perspective(dvec3(0.5, 1, -6), dvec3(0)));
    EXPECT_EQ(from_below.inner().size(), 1u);
    EXPECT_EQ(from_below.drawing.visible_edges().size(), 7u);
    EXPECT_GT(from_below.agreement(), 0.99);
}

TEST(OwnSides, WhatHidesNothingHasNoInnerLines) {
    EXPECT_TRUE(Seen(meshes::box(), perspective(corner_eye, dvec3(0)), usage_draw).inner().empty());
    meshes::Mesh glass = meshes::box();
    glass.occluding.assign(6, 0);
    EXPECT_TRUE(Seen(glass, perspective(corner_eye, dvec3(0))).inner().empty());
}

TEST(OwnSides, SteepnessIsTheSlopeOfTheSteeperFacetInFront) {
    const View view = orthographic(corner_eye, dvec3(0), 6.0);
    const Seen box(meshes::box(), view);
    const dvec3 towards = glm::normalize(corner_eye);
    const double depth_per_px = 6.0 / view.width / (view.far_clip - view.near_clip);
    std::set<int> slopes;  // of the three directions of faces: tan of the angle away from the viewer
    for (int axis = 0; axis < 3; ++axis) {
        const double cosine = std::abs(towards[axis]);
        slopes.insert(int(std::lround(1e8 * depth_per_px * std::sqrt(1 - cosine * cosine) / cosine)));
    }
    std::multiset<int> found;
    for (Index q = 0; q < box.drawing.clipped.pieces.count(); ++q)
        for (Index i = box.drawing.clipped.pieces.begin(q); i + 1 < box.drawing.clipped.pieces.end(q); ++i) {
            const int slope = int(std::lround(1e8 * box.sides.steepness[i]));
            const auto known = slopes.lower_bound(slope - 1);
            if (slope == 0)
                found.insert(0);
            else if (known != slopes.end() && *known <= slope + 1)
                found.insert(*known);
            else
                ADD_FAILURE() << slope;
        }
    // Three edges turn away; of the four of each face in front, two belong to another such face.
    const int low = *slopes.begin(), middle = *std::next(slopes.begin()), high = *slopes.rbegin();
    EXPECT_EQ(found, (std::multiset<int>{0, 0, 0, low, low, middle, middle, middle, high, high, high, high}));
}

TEST(OwnSides, SampledVisibilityAgreesWithRays) {
    EXPECT_GT(Seen(meshes::sphere(32), perspective(corner_eye, dvec3(0))).agreement(), 0.97);
    EXPECT_GT(Seen(meshes::cylinder(24), perspective(corner_eye, dvec3(0))).agreement(), 0.99);
    EXPECT_GT(Seen(meshes::l_shape(), perspective(corner_eye, dvec3(0))).agreement(), 0.99);
}
