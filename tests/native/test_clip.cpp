// SPDX-License-Identifier: GPL-3.0-or-later
// Clipping at analytic positions: the near plane, the four borders, the eye plane.
#include <gtest/gtest.h>
#include <random>

#include "wires.h"

using namespace fovea;
using namespace fovea::draw;
using namespace fovea::wires;

namespace {

constexpr double px_tolerance = 1e-3;  // pixels are stored in single precision

/// The only piece of a polyline.
struct Piece {
    ClippedPaths clipped;
    Index first, last;
    Piece(const std::vector<dvec3>& line, const View& view, double margin)
        : clipped(project_line(line, view, {.margin = margin})) {
        EXPECT_EQ(clipped.pieces.count(), 1u);
        first = first_of(clipped, 0);
        last = last_of(clipped, 0);
    }
};

}  // namespace

TEST(Clip, AtTheNearPlane) {
    for (const bool ortho : {false, true})
        for (const double near_clip : {0.01, 0.1, 2.0}) {
            const View view = camera(near_clip, ortho);
            const dvec3 before(0.0, 0.0, -0.5 * near_clip), behind(0.3, 0.2, -4.0);
            const Piece piece({before, behind}, view, 0.1);
            const double t = 0.5 * near_clip / (4.0 - 0.5 * near_clip);
            const dvec3 cut = glm::mix(before, behind, t);
            EXPECT_NEAR(piece.clipped.position_view[piece.first].z, -near_clip, 1e-6);
            EXPECT_NEAR(piece.clipped.source_t[piece.first], t, 1e-6);
            const dvec2 expected = drawing::pixel_of(view, cut);
            EXPECT_NEAR(piece.clipped.px[piece.first].x, expected.x, px_tolerance);
            EXPECT_NEAR(piece.clipped.px[piece.first].y, expected.y, px_tolerance);
            EXPECT_NEAR(piece.clipped.depth[piece.first], 1.0, 1e-6) << "depth is 1 at the near plane";
        }
}

TEST(Clip, AtEachBorderAndItsMargin) {
    for (const bool ortho : {false, true})
        for (const double margin : {0.0, 0.1, 1.0}) {
            const View view = camera(0.1, ortho);
            const double distance = ortho ? 1.0 : 3.0;
            const double left = -0.5 * margin * view.width, right = view.width - left;
            const double bottom = -0.5 * margin * view.height, top = view.height - bottom;
            const struct {
                dvec2 towards, end;
            } cases[] = {
                {{-9, 0}, {left, 240}}, {{9, 0}, {right, 240}}, {{0, -9}, {320, bottom}}, {{0, 9}, {320, top}}};
            for (const auto& [towards, end] : cases) {
                const Piece piece({{0, 0, -3}, dvec3(towards * distance, -3)}, view, margin);
                EXPECT_NEAR(piece.clipped.px[piece.last].x, end.x, px_tolerance);
                EXPECT_NEAR(piece.clipped.px[piece.last].y, end.y, px_tolerance);
                EXPECT_EQ(piece.clipped.px[piece.first], vec2(320, 240));
            }
        }
}

TEST(Clip, ASlantedSegmentAtTheRightBorder) {
    // x = 0.8 (-z) on the way from the middle at distance 2 to (8, 0, -6): 8 t = 0.8 (2 + 4 t).
    const View view = camera();
    const Piece piece({{0, 0, -2}, {8, 0, -6}}, view, 0.0);
    const double t = 1.6 / 4.8;
    EXPECT_NEAR(piece.clipped.source_t[piece.last], t, 1e-6);
    EXPECT_NEAR(piece.clipped.position_view[piece.last].z, -2 - 4 * t, 1e-5);
    EXPECT_NEAR(piece.clipped.px[piece.last].x, 640.0, px_tolerance);
    EXPECT_NEAR(piece.clipped.depth[piece.last], 0.1 / (2 + 4 * t), 1e-6);
}

TEST(Clip, ThroughTheEyePlane) {
    // From behind the viewer, over the head, into the picture.
    const View view = camera();
    for (const dvec3 behind : {dvec3(0, 0.5, 3), dvec3(2, 1, 1e-9), dvec3(-1, 1, 0), dvec3(0.3, 0.2, 100)}) {
        const ClippedPaths clipped = project_line({behind, {0.1, -0.1, -5}}, view);
        ASSERT_EQ(clipped.pieces.count(), 1u);
        EXPECT_EQ(clipped.px[last_of(clipped, 0)], vec2(drawing::pixel_of(view, {0.1f, -0.1f, -5})));
        for (const vec2& px : clipped.px) {
            EXPECT_TRUE(px.x >= -33 && px.x <= 673 && px.y >= -25 && px.y <= 505) << px.x << " " << px.y;
        }
    }
    EXPECT_EQ(project_line({{0, 0, 5}, {1, 0, 0.1}}, view).pieces.count(), 0u) << "all behind";
    EXPECT_EQ(project_line({{0, 0, 0}, {0, 0, -0.05}}, view).pieces.count(), 0u) << "all before the near plane";
}

TEST(Clip, BesideTheFrameLeavesNothing) {
    const View view = camera();
    EXPECT_EQ(project_line({{9, -1, -3}, {9, 1, -3}}, view).pieces.count(), 0u);
    EXPECT_EQ(project_line({{-6, 0.1, -3}, {0.1, 6, -3}}, view).pieces.count(), 0u) << "past the upper left corner";
    EXPECT_EQ(project_line({{-3, -3, 1}, {3, -3, 1}}, view).samples, 0u);
}

TEST(Clip, LeavingAndComingBackGivesTwoPieces) {
    const View view = camera();
    const Wires wires({{{-1, 0, -3}, {9, 0.5, -3}, {-1, 1, -3}}});
    const ClippedPaths clipped = wires.project(view, {.margin = 0.0});
    ASSERT_EQ(clipped.pieces.count(), 2u);
    EXPECT_NEAR(clipped.px[last_of(clipped, 0)].x, 640.0, px_tolerance);
    EXPECT_NEAR(clipped.px[first_of(clipped, 1)].x, 640.0, px_tolerance);
    EXPECT_EQ(clipped.path[1], 0u);
    EXPECT_EQ(clipped.source[first_of(clipped, 1)], 1u);
    EXPECT_EQ(clipped.source[last_of(clipped, 1)], 2u);
}

TEST(Clip, AClosedPathIsAClosedPieceWhileItIsWhole) {
    const std::vector<dvec3> square{{-1, -1, -3}, {1, -1, -3}, {1, 1, -3}, {-1, 1, -3}, {-1, -1, -3}};
    const ClippedPaths whole = project_line(square, camera());
    ASSERT_EQ(whole.pieces.count(), 1u);
    EXPECT_TRUE(whole.closed[0]);
    std::vector<dvec3> aside = square;
    for (dvec3& p : aside) p.x += 2.5;
    const ClippedPaths cut = project_line(aside, camera());
    ASSERT_EQ(cut.pieces.count(), 2u);
    EXPECT_FALSE(cut.closed[0] || cut.closed[1]);
    std::vector<dvec3> open(square.begin(), square.end() - 1);
    EXPECT_FALSE(project_line(open, camera()).closed[0]);
}

TEST(Clip, EveryPointLiesOnItsSegment) {
    std::mt19937 random(3);
    std::uniform_real_distribution<double> wide(-6, 6), deep(-9, 2);
    const View view = camera();
    std::size_t points = 0;
    for (int k = 0; k < 300; ++k) {
        const Wires wires({{{wide(random), wide(random), deep(random)},
                            {wide(random), wide(random), deep(random)},
                            {wide(random), wide(random), deep(random)}}});
        const ClippedPaths clipped = wires.project(view);
        for (Index i = 0; i < clipped.px.size(); ++i) {
            const Index from = clipped.source[i], to = std::min(from + 1, 2u);
            const dvec3 on_path = glm::mix(dvec3(wires.paths.points_obj[from]), dvec3(wires.paths.points_obj[to]),
                                           double(clipped.source_t[i]));
            EXPECT_LT(glm::length(on_path - dvec3(clipped.position_view[i])), 2e-5);
            const dvec2 px = drawing::pixel_of(view, dvec3(clipped.position_view[i]));
            EXPECT_LT(glm::length(px - dvec2(clipped.px[i])), 0.02 / std::abs(clipped.position_view[i].z));
            EXPECT_LE(std::abs(px.x - 320), 352.01);
            EXPECT_LE(std::abs(px.y - 240), 264.01);
            EXPECT_LE(clipped.position_view[i].z, -0.0999f);
            ++points;
        }
    }
    EXPECT_GT(points, 300u);
}
