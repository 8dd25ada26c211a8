// SPDX-License-Identifier: GPL-3.0-or-later
// Fairing of lines along the edges of rounded surfaces (runs/fair.h).
#include <gtest/gtest.h>
#include <numbers>

#include <fovea/runs/fair.h>

#include "drawing.h"

using namespace fovea;
using namespace fovea::draw;
using namespace fovea::drawing;
using namespace fovea::meshes;

namespace {

constexpr int across = 16;
constexpr double amplitude = 0.03, contour_px = 1.5;

/// Two slopes that meet in a groove, which zigzags about x = 0.
Mesh zigzag(Shape shape) {
    Mesh mesh = relief(across, [](double x, double) { return 0.6 * std::abs(x); });
    for (int j = 0; j <= across; ++j)
        mesh.positions[across / 2 + (across + 1) * j].x = float(j % 2 ? amplitude : -amplitude);
    mesh.shape = shape;
    return mesh;
}
int middle_edge(Mesh& mesh, int j) {
    const int v = across / 2 + (across + 1) * j;
    return mesh.edge(v, v + across + 1);
}

Drawing from_above(const Mesh& mesh, const std::vector<LineSet>& sets) {
    return Drawing({place(mesh)}, orthographic({0, 0, 5}, {0, 0, 0}, 2.5), sets);
}

ClippedPaths faired(const Drawing& drawing, double most_px = contour_px) {
    ClippedPaths clipped = drawing.clipped;
    fair(clipped, drawing.paths, drawing.scene, most_px);
    return clipped;
}

/// Sum of the angles by which the pieces turn.
double turns(const ClippedPaths& clipped) {
    double sum = 0.0;
    for (Index q = 0; q < clipped.pieces.count(); ++q)
        for (Index i = clipped.pieces.begin(q) + 1; i + 1 < clipped.pieces.end(q); ++i) {
            const dvec2 before = dvec2(clipped.px[i]) - dvec2(clipped.px[i - 1]),
                        after = dvec2(clipped.px[i + 1]) - dvec2(clipped.px[i]);
            sum += std::abs(std::atan2(cross(before, after), glm::dot(before, after)));
        }
    return sum;
}

/// How far points have moved at most.
double moved_px(const ClippedPaths& now, const ClippedPaths& before) {
    double most = 0.0;
    for (Index i = 0; i < now.px.size(); ++i) most = std::max(most, double(glm::distance(now.px[i], before.px[i])));
    return most;
}

}  // namespace

TEST(Fair, TakesTheZigzagOutOfACreaseOfARoundedSurfaceButNotItsEnds) {
    const Drawing drawing = from_above(zigzag(Shape::rounded), {line_set({"crease"})});
    ASSERT_EQ(drawing.clipped.pieces.count(), 1u);
    const ClippedPaths now = faired(drawing);
    const double zigzag_px = amplitude * 640 / 2.5;
    for (Index i = 3; i + 3 < now.px.size(); ++i) {
        EXPECT_NEAR(std::abs(drawing.clipped.px[i].x - 320.0), zigzag_px, 0.01);
        EXPECT_NEAR(now.px[i].x, 320.0, zigzag_px / 4.0) << i;
    }
    EXPECT_EQ(now.px.front(), drawing.clipped.px.front());
    EXPECT_EQ(now.px.back(), drawing.clipped.px.back());
    EXPECT_EQ(now.arc_px, drawing.clipped.arc_px);
    EXPECT_EQ(now.position_view, drawing.clipped.position_view);
}

TEST(Fair, LeavesHardSurfacesAndMarkedEdgesAsTheyAre) {
    const Drawing hard = from_above(zigzag(Shape::hard), {line_set({"crease"})});
    EXPECT_EQ(faired(hard).px, hard.clipped.px);
    Mesh marked = zigzag(Shape::rounded);
    std::vector<int> edges;
    for (int j = 0; j < across; ++j) edges.push_back(middle_edge(marked, j));
    marked.sharp = marked.edge_flags(edges);
    const Drawing sharp = from_above(marked, {line_set({"crease"})});
    EXPECT_EQ(faired(sharp).px, sharp.clipped.px);
}

TEST(Fair, LeavesAPointWhereAnotherLineEnds) {
    Mesh mesh = zigzag(Shape::rounded);
    const int meeting = across / 2 + (across + 1) * (across / 2);
    mesh.edge_mark = mesh.edge_flags({mesh.edge(meeting, meeting + 1)});
    const Drawing drawing = from_above(mesh, {line_set({"crease"}), line_set({"edge_mark"})});
    const ClippedPaths now = faired(drawing);
    const dvec2 place = pixel_of(drawing.view, dvec3(mesh.positions[meeting]));
    int there = 0, moved = 0;
    for (Index i = 0; i < now.px.size(); ++i) {
        there += glm::distance(dvec2(drawing.clipped.px[i]), place) < 0.01 && now.px[i] == drawing.clipped.px[i];
        moved += now.px[i] != drawing.clipped.px[i];
    }
    EXPECT_EQ(there, 2) << "the crease, and what ends there";
    EXPECT_GE(moved, across - 4);
}

/// A double cone whose rim zigzags.
Mesh rough_rim(Shape shape) {
    constexpr int n = 48;
    Mesh mesh("double cone", {{0, 0, 0.5}, {0, 0, -0.5}});
    for (int i = 0; i < n; ++i) {
        const double angle = 2.0 * std::numbers::pi * i / n, radius = i % 2 ? 1.0 : 0.988;
        mesh.positions.push_back(vec3(radius * std::cos(angle), radius * std::sin(angle), 0.0));
    }
    for (int i = 0; i < n; ++i) {
        const int a = 2 + i, b = 2 + (i + 1) % n;
        mesh.add_polygon({0, a, b});
        mesh.add_polygon({1, b, a});
    }
    mesh.shape = shape;
    return mesh;
}

TEST(Fair, MovesContoursOfRoundedSurfacesByLittleAndTheyTurnLess) {
    for (const Shape shape : {Shape::smooth, Shape::hard}) {
        const Drawing drawing = from_above(rough_rim(shape), {line_set({"contour"})});
        EXPECT_EQ(faired(drawing).px, drawing.clipped.px);
    }
    const Drawing drawing = from_above(rough_rim(Shape::rounded), {line_set({"contour"})});
    ASSERT_EQ(drawing.clipped.pieces.count(), 1u);
    ASSERT_TRUE(drawing.clipped.closed[0]);
    const ClippedPaths now = faired(drawing);
    EXPECT_GT(moved_px(now, drawing.clipped), 1.0);
    EXPECT_LE(moved_px(now, drawing.clipped), contour_px + 1e-4);
    const double whole = 2.0 * std::numbers::pi;
    EXPECT_LT(turns(now) - whole, 0.3 * (turns(drawing.clipped) - whole));
    EXPECT_EQ(now.px.front(), now.px.back());
    EXPECT_EQ(faired(drawing, 0.0).px, drawing.clipped.px);
}
