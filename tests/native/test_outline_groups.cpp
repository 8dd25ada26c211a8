// SPDX-License-Identifier: GPL-3.0-or-later
// Placements of one group have one outline together.
#include <gtest/gtest.h>

#include <fovea/runs/outer_parts.h>

#include "drawing.h"

namespace fovea {
using namespace draw;
namespace {

using namespace drawing;

/// A small box in the middle of a large one that stands behind it, seen from the front, and a box beside them.
Drawing boxes(const char* kind, std::uint64_t front, std::uint64_t back) {
    const dmat4 large = glm::scale(moved({0, 6, 0}), dvec3(3.0));
    std::vector<Placement> placements{place(meshes::box(), moved({0, 0, 0}), 1), place(meshes::box(), large, 2),
                                      place(meshes::box(), moved({4, 0, 0}), 3)};
    placements[0].group = front;
    placements[1].group = back;
    return Drawing(placements, perspective({0, -14, 0}, dvec3(0), 60, 480, 270), {line_set({kind})});
}

double length_of(const Drawing& drawn, const Runs& runs, Index placement) {
    double sum = 0.0;
    for (std::size_t r = 0; r < runs.size(); ++r)
        if (drawn.paths.placement[drawn.clipped.path[runs.piece[r]]] == placement)
            sum += runs.end_px[r] - runs.start_px[r];
    return sum;
}

Runs outlined(const Drawing& drawn) {
    return without_inner_outlines(drawn.clipped, drawn.paths, drawn.tracer, drawn.runs, 2.0, Cancel());
}

TEST(OutlineGroup, TheContourBetweenTwoMembersIsNotDrawn) {
    const Drawing drawn = boxes("contour", 7, 7);
    ASSERT_GT(length_of(drawn, drawn.runs, 0), 100.0);
    const Runs found = outlined(drawn);
    EXPECT_EQ(length_of(drawn, found, 0), 0.0);
    for (const Index other : {1u, 2u})
        EXPECT_NEAR(length_of(drawn, found, other), length_of(drawn, drawn.runs, other), 1e-6);
}

TEST(OutlineGroup, WithoutGroupsAndBetweenGroupsContoursStay) {
    for (const auto& [front, back] : {std::pair(0, 0), {7, 0}, {7, 8}}) {
        const Drawing drawn = boxes("contour", front, back);
        const Runs found = outlined(drawn);
        for (const Index placement : {0u, 1u, 2u})
            EXPECT_NEAR(length_of(drawn, found, placement), length_of(drawn, drawn.runs, placement), 1e-6);
    }
}

TEST(OutlineGroup, CreasesBetweenMembersStay) {
    const Drawing drawn = boxes("crease", 7, 7);
    ASSERT_GT(length_of(drawn, drawn.runs, 0), 100.0);
    EXPECT_NEAR(length_of(drawn, outlined(drawn), 0), length_of(drawn, drawn.runs, 0), 1e-6);
}

TEST(OutlineGroup, HasOneSilhouette) {
    for (const char* kind : {"silhouette", "smooth_silhouette"}) {
        const Drawing apart = boxes(kind, 0, 0), together = boxes(kind, 7, 7);
        if (std::string(kind) == "silhouette") {
            EXPECT_GT(length_of(apart, apart.runs, 0), 100.0);
        }
        EXPECT_EQ(length_of(together, together.runs, 0), 0.0);
        for (const Index other : {1u, 2u})
            EXPECT_NEAR(length_of(together, together.runs, other), length_of(apart, apart.runs, other), 1e-6);
    }
}

}  // namespace
}  // namespace fovea
