// SPDX-License-Identifier: GPL-3.0-or-later
// Which parts of contours are the outer boundary of their object.
#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <fovea/runs/outer_parts.h>

#include "drawing.h"
#include "refused.h"

namespace fovea {
using namespace draw;
namespace {

using namespace drawing;

/// Contours of two boxes in one mesh, one in front of the other, beside a ball.
Drawing boxes_and_ball() {
    const meshes::Mesh box = meshes::box();
    std::vector<vec3> positions = box.positions;
    meshes::Polygons polygons;
    for (int copy = 0; copy < 2; ++copy)
        for (std::size_t f = 0; f + 1 < box.polygon_offsets.size(); ++f) {
            polygons.emplace_back();
            for (int c = box.polygon_offsets[f]; c < box.polygon_offsets[f + 1]; ++c)
                polygons.back().push_back(box.corner_verts[c] + copy * int(box.positions.size()));
        }
    for (const vec3& p : box.positions) positions.push_back(0.6f * p + vec3(0.2f, -2.2f, 0.2f));
    const meshes::Mesh pair = meshes::of_polygons("pair", positions, polygons);
    return Drawing({place(pair, moved({2, 0, 0}), 1), place(meshes::sphere(16), moved({-2, 0, 0}), 2)},
                   perspective({0, -14, 4}, dvec3(0), 50, 480, 270), {line_set({"contour"})});
}

OuterParts parts_of(const Drawing& drawn, Kinds sure, double step_px = 3.0) {
    const std::vector<Kinds> per_path(drawn.paths.count(), sure);
    return outer_parts(drawn.clipped, drawn.paths, drawn.tracer, drawn.runs, per_path, step_px, Cancel());
}

double length_of(const Runs& runs) {
    double sum = 0.0;
    for (std::size_t r = 0; r < runs.size(); ++r) sum += runs.end_px[r] - runs.start_px[r];
    return sum;
}

}  // namespace

TEST(OuterParts, RunsArePartedAndKeepTheirLength) {
    const Drawing drawn = boxes_and_ball();
    const OuterParts found = parts_of(drawn, 0);
    EXPECT_EQ(found.outer.size(), found.runs.size());
    EXPECT_EQ(found.source.size(), found.runs.size());
    EXPECT_GT(found.runs.size(), drawn.runs.size());
    EXPECT_NEAR(length_of(found.runs), length_of(drawn.runs), 1e-6);
}

TEST(OuterParts, OfOneObjectBeforeItselfSomeAreOuterAndSomeAreNot) {
    const OuterParts found = parts_of(boxes_and_ball(), 0);
    EXPECT_NE(std::ranges::find(found.outer, 0), found.outer.end());
    EXPECT_NE(std::ranges::find(found.outer, 1), found.outer.end());
}

TEST(OuterParts, WhatIsSureIsOuterAndNotParted) {
    const Drawing drawn = boxes_and_ball();
    const OuterParts found = parts_of(drawn, ~Kinds(0));
    EXPECT_EQ(found.runs.start_px, drawn.runs.start_px);
    EXPECT_EQ(std::ranges::find(found.outer, 0), found.outer.end());
}

TEST(OuterParts, AreTheSameForAnyNumberOfThreads) {
    const Drawing drawn = boxes_and_ball();
    const OuterParts many = parts_of(drawn, 0);
    tbb::global_control one(tbb::global_control::max_allowed_parallelism, 1);
    const OuterParts alone = parts_of(drawn, 0);
    EXPECT_EQ(many.runs.start_px, alone.runs.start_px);
    EXPECT_EQ(many.outer, alone.outer);
    EXPECT_EQ(many.source, alone.source);
}

TEST(OuterParts, WrongInputIsNamed) {
    const Drawing drawn = boxes_and_ball();
    const std::vector<Kinds> few(drawn.paths.count() - 1, 0);
    EXPECT_NE(refused([&] {
                  outer_parts(drawn.clipped, drawn.paths, drawn.tracer, drawn.runs, few, 3.0, Cancel());
              }).find("one value per path"),
              std::string::npos);
    EXPECT_NE(refused([&] { parts_of(drawn, 0, 0.0); }).find("step_px must be more than 0"), std::string::npos);
}

}  // namespace fovea
