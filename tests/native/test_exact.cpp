// SPDX-License-Identifier: GPL-3.0-or-later
// Exact visibility where the answer is known.
#include <glm/gtc/quaternion.hpp>
#include <gtest/gtest.h>
#include <random>

#include <fovea/visibility/exact.h>

#include "wires.h"

using namespace fovea;
using namespace fovea::draw;
using namespace fovea::meshes;
using namespace fovea::drawing;
using namespace fovea::wires;

namespace {

std::size_t visible_edges(const Mesh& mesh, const View& view, dmat4 at = dmat4(1.0)) {
    return Drawing({place(mesh, at)}, view, {all_edges()}).visible_edges().size();
}

/// Pixels of image position (along x) where the visibility of a straight wire changes behind or through an occluder.
std::vector<double> changes(const std::vector<dvec3>& wire, const View& view, const std::vector<Placement>& occluders) {
    const Wires wires({wire}, dmat4(1.0), occluders);
    const ClippedPaths clipped = wires.project(view);
    const Tracer tracer(wires.scene, view);
    const Runs runs = exact_visibility(clipped, wires.paths, tracer, Cancel());
    std::vector<double> result;
    const Index last = last_of(clipped, 0);
    const double length = clipped.arc_px[last] - clipped.arc_px[0];
    const auto x_at = [&](double arc) {
        return glm::mix(double(clipped.px[0].x), double(clipped.px[last].x), (arc - clipped.arc_px[0]) / length);
    };
    for (std::size_t r = 0; r < runs.piece.size(); ++r) {
        if (runs.start_px[r] > clipped.arc_px[0]) result.push_back(x_at(runs.start_px[r]));
        if (runs.end_px[r] < clipped.arc_px[last]) result.push_back(x_at(runs.end_px[r]));
    }
    return result;
}

Mesh rectangle(vec3 a, vec3 b, vec3 c, vec3 d) { return of_polygons("rectangle", {a, b, c, d}, {{0, 1, 2, 3}}); }

/// A square that faces the camera at the origin.
Mesh screen(double distance) {
    const double half = 2.0 * distance;
    return rectangle(dvec3(-half, -half, -distance), dvec3(half, -half, -distance), dvec3(half, half, -distance),
                     dvec3(-half, half, -distance));
}

double visible_share(const std::vector<dvec3>& wire, const View& view, const std::vector<Placement>& occluders) {
    const Wires wires({wire}, dmat4(1.0), occluders);
    const ClippedPaths clipped = wires.project(view);
    const Runs runs = exact_visibility(clipped, wires.paths, Tracer(wires.scene, view), Cancel());
    double visible = 0.0;
    for (std::size_t r = 0; r < runs.piece.size(); ++r) visible += runs.end_px[r] - runs.start_px[r];
    return visible / (clipped.arc_px.back() - clipped.arc_px.front());
}

}  // namespace

TEST(Exact, NineOfTwelveEdgesOfABoxAreSeenFromItsCorner) {
    for (const View& view : {corner_view, orthographic({4, -5, 3}, {0, 0, 0}, 5)}) {
        const Drawing drawing({place(box())}, view, {all_edges()});
        EXPECT_EQ(drawing.visible_edges().size(), 9u);
        for (Index e = 0; e < 12; ++e) {
            const auto [all, visible] = drawing.length_of(e);
            EXPECT_TRUE(visible == 0.0 || visible == all) << "edge " << e << " is seen whole or not at all";
            const Edge edge = drawing.scene.placements[0].surface->edges[e];
            // The hidden corner is -x, +y, -z: vertex 2.
            EXPECT_EQ(visible == 0.0, edge.x == 2 || edge.y == 2);
        }
    }
}

TEST(Exact, MirroredAndStretchedBoxesToo) {
    for (const dvec3 size :
         {dvec3(-1, 1, 1), dvec3(1, 1, -1), dvec3(-1, -1, -1), dvec3(0.2, 1.4, 0.6), dvec3(-1, 0.3, 1)})
        EXPECT_EQ(visible_edges(box(), corner_view, scaled(size)), 9u);
    EXPECT_EQ(visible_edges(flipped(box(), [](int) { return true; }), corner_view), 9u) << "turned inside out";
}

TEST(Exact, ATetrahedronBehindABoxIsHidden) {
    const dvec3 way = glm::normalize(dvec3(4, -5, 3));
    for (const double apart : {-2.2, -8.0}) {
        const Drawing behind({place(box()), place(tetrahedron(), moved(apart * way) * scaled(dvec3(0.3)), 2)},
                             corner_view, {all_edges()});
        EXPECT_GT(behind.total_px(1), 50.0);
        EXPECT_EQ(behind.visible_px(1), 0.0);
        EXPECT_EQ(behind.visible_edges(0).size(), 9u);
    }
    const Drawing before({place(box()), place(tetrahedron(), moved(2.2 * way) * scaled(dvec3(0.3)), 2)}, corner_view,
                         {all_edges()});
    EXPECT_GE(before.visible_edges(1).size(), 3u);
    EXPECT_EQ(before.visible_edges(1),
              Drawing({place(tetrahedron(), moved(2.2 * way) * scaled(dvec3(0.3)))}, corner_view, {all_edges()})
                  .visible_edges(0));
}

TEST(Exact, AnEdgeThroughAFaceChangesAtTheAnalyticPixel) {
    // Face z = -5 + .4 x.
    const auto on_face = [](float x, float y) { return vec3(x, y, -5.0f + 0.4f * x); };
    const Mesh face = rectangle(on_face(-1.5f, -1.5f), on_face(1.5f, -1.5f), on_face(1.5f, 1.5f), on_face(-1.5f, 1.5f));
    const dvec3 way(0.9, 0.15, -1.1);
    for (const bool ortho : {false, true})
        for (const double x : {-0.31, 0.0, 0.3}) {
            const View view = camera(0.1, ortho);
            const dvec3 hit(x, 0.2, -5.0 + 0.4 * x);
            const auto found = changes({hit - way, hit + way}, view, {place(face)});
            ASSERT_EQ(found.size(), 1u);
            EXPECT_NEAR(found[0], pixel_of(view, hit).x, exact_tolerance_px + 0.02);
        }
}

TEST(Exact, BehindASilhouetteItChangesAtTheAnalyticPixel) {
    const View view = camera();
    const Mesh post = rectangle({0.123f, -3, -4}, {0.456f, -3, -4}, {0.456f, 3, -4}, {0.123f, 3, -4});
    const auto found = changes({{-2, 0.1, -6}, {2.5, -0.2, -8}}, view, {place(post)});
    ASSERT_EQ(found.size(), 2u);
    EXPECT_NEAR(found[0], pixel_of(view, {0.123, 0, -4}).x, exact_tolerance_px + 0.02);
    EXPECT_NEAR(found[1], pixel_of(view, {0.456, 0, -4}).x, exact_tolerance_px + 0.02);
}

TEST(Exact, BehindAFenceEveryPostIsFound) {
    // Posts and gaps of 5 pixels, wider than a sample.
    const View view = camera();
    std::vector<Placement> fence;
    std::vector<double> expected;
    for (int i = 0; i < 20; ++i) {
        const float x0 = -0.8f + 0.05f * i, x1 = x0 + 0.025f;
        fence.push_back(place(rectangle({x0, -3, -2}, {x1, -3, -2}, {x1, 3, -2}, {x0, 3, -2})));
        for (const float x : {x0, x1}) expected.push_back(pixel_of(view, {x, 0, -2}).x);
    }
    const auto found = changes({{-4, 0.5, -5}, {4, -0.5, -5.5}}, view, fence);
    ASSERT_EQ(found.size(), expected.size());
    for (std::size_t i = 0; i < found.size(); ++i) EXPECT_NEAR(found[i], expected[i], exact_tolerance_px + 0.02) << i;
}

TEST(Exact, NoLineShowsThroughTheSeamsOfASurface) {
    // Wires that fall exactly onto edges, diagonals and corners of the triangles before them.
    for (const bool ortho : {false, true}) {
        const View view = camera(0.1, ortho);
        const Mesh triangles = grid(16, 3.0f);
        const Placement curtain = place(triangles, moved({0, 0, -4}));
        const double scale = ortho ? 1.0 : 2.0;
        const auto behind = [&](double x, double y) { return dvec3(scale * x, scale * y, -8); };
        for (int i = -8; i <= 8; ++i) {
            const double at = 3.0 * i / 8;
            for (const auto& [from, to] :
                 {std::pair(behind(at, -3), behind(at, 3)), std::pair(behind(-3, at), behind(3, at)),
                  std::pair(behind(-3, at), behind(3, at + 6)), std::pair(behind(-3, at), behind(3, at - 6))}) {
                const Wires wires({{from, to}}, dmat4(1.0), {curtain});
                const ClippedPaths clipped = wires.project(view);
                const Tracer tracer(wires.scene, view);
                const Runs runs = exact_visibility(clipped, wires.paths, tracer, Cancel());
                EXPECT_TRUE(runs.piece.empty()) << "from " << from.x << " " << from.y << " to " << to.x << " " << to.y;
            }
        }
    }
}

TEST(Exact, LinesOnTheirOwnSurfaceAreSeen) {
    for (const double degrees : {90.0, 45.0, 10.0, 2.0}) {
        const double a = glm::radians(degrees);
        const dvec3 eye(6 * std::cos(a), 0.1, 6 * std::sin(a));
        for (const View& view : {perspective(eye, {0, 0, 0}), orthographic(eye, {0, 0, 0}, 4)}) {
            const Drawing drawing({place(grid(8))}, view, {all_edges(), line_set({"border"})});
            EXPECT_NEAR(drawing.visible_px(0), drawing.total_px(0), 1e-6) << degrees;
            EXPECT_EQ(drawing.lines().size(), 144u);
        }
    }
}

TEST(Exact, TheFrontOfASphereIsSeenAndItsBackIsNot) {
    const Drawing drawing({place(sphere(24))}, corner_view, {all_edges()});
    const Surface& surface = *drawing.scene.placements[0].surface;
    const dvec3 eye(4, -5, 3);
    int front = 0, back = 0;
    for (Index e = 0; e < surface.mesh_edges; ++e) {
        int facing = 0;
        for (Index i = surface.edge_rows.begin(e); i < surface.edge_rows.end(e); ++i) {
            const dvec4 plane(surface.facet_plane[surface.edge_sides[i].facet()]);
            facing += glm::dot(dvec3(plane), eye) > plane.w;
        }
        const auto [all, visible] = drawing.length_of(e);
        EXPECT_NEAR(visible, facing > 0 ? all : 0.0, 0.13) << e;
        ++(facing > 0 ? front : back);
    }
    EXPECT_GT(front, 400);
    EXPECT_GT(back, 400);
}

TEST(Exact, ASurfaceALittleInFrontHides) {
    for (const double distance : {0.5, 10.0, 300.0})
        for (const bool ortho : {false, true}) {
            const View view = camera(0.1, ortho);
            const double half = ortho ? 0.5 : 0.5 * distance;
            const std::vector<dvec3> wire{{-half, 0.1, -distance}, {half, 0.2, -distance}};
            for (const double before : {2e-4, 5e-5})
                EXPECT_EQ(visible_share(wire, view, {place(screen(distance * (1 - before)))}), 0.0) << distance;
            EXPECT_EQ(visible_share(wire, view, {place(screen(distance))}), 1.0) << "on it";
            EXPECT_EQ(visible_share(wire, view, {place(screen(distance * 1.001))}), 1.0) << "before it";
        }
}

TEST(Exact, ABoxOnAFloorKeepsItsBottomEdges) {
    for (const float floor : {3.0f, 50.0f, 1000.0f})
        for (const double height : {8.0, 3.0, 0.5}) {
            for (const bool ortho : {false, true}) {
                const dvec3 eye(6, -7, height);
                const View view = ortho ? orthographic(eye, {0, 0, 0}, 5) : perspective(eye, {0, 0, 0});
                const Drawing drawing(
                    {place(box(vec3(-1, -1, 0), vec3(1, 1, 2))), place(grid(1, floor), dmat4(1.0), 2)}, view,
                    {all_edges()});
                // Bottom edges towards the viewer: 0-1 and 1-3.
                for (Index e = 0; e < 12; ++e) {
                    const Edge edge = drawing.scene.placements[0].surface->edges[e];
                    const Index low = std::min(edge.x, edge.y), high = std::max(edge.x, edge.y);
                    if ((low == 0 && high == 1) || (low == 1 && high == 3)) {
                        const auto [all, visible] = drawing.length_of(e);
                        EXPECT_NEAR(visible, all, 0.13)
                            << "floor " << floor << ", eye at " << height << (ortho ? " ortho" : "");
                    }
                }
            }
        }
}

TEST(Exact, AFloorOfAnySizeAndSlantHidesNothingThatStandsOnIt) {
    std::mt19937 random(1);
    std::uniform_real_distribution<double> any(-1, 1);
    for (int k = 0; k < 60; ++k) {
        const dvec3 axis = glm::normalize(dvec3{any(random), any(random), any(random)});
        const dmat4 turn = glm::mat4_cast(glm::angleAxis(3.0 * any(random), axis));
        const dvec3 eye{8.0 * glm::normalize(dvec2{any(random), any(random)}), 0.1 + 3.0 * std::abs(any(random))};
        const View view = perspective(dvec3(turn * dvec4(eye, 1.0)), {0, 0, 0});
        const auto turned = [&](Mesh mesh) {
            for (vec3& p : mesh.positions) p = vec3(turn * dvec4(dvec3(p), 1.0));
            return mesh;
        };
        const Placement standing = place(turned(box(vec3(-1, -1, 0), vec3(1, 1, 2))));
        const Drawing alone({standing}, view, {all_edges()});
        const Drawing on_floor({standing, place(turned(grid(1, k % 2 ? 300.0f : 3000.0f)), dmat4(1.0), 2)}, view,
                               {all_edges()});
        EXPECT_NEAR(on_floor.visible_px(0), alone.visible_px(0), 0.2) << k;
    }
}

TEST(Exact, BoxesThatTouchKeepTheirSharedEdges) {
    const View view = perspective({5, -7, 4}, {1, 0, 0});
    const Drawing drawing({place(box()), place(box(), moved({2, 0, 0}), 2)}, view, {all_edges()});
    // The edge on top between them, y from -1 to 1 at x = 1, z = 1, belongs to both.
    int tops = 0;
    for (Index placement : {0u, 1u})
        for (Index e = 0; e < 12; ++e) {
            const Edge edge = drawing.scene.placements[0].surface->edges[e];
            const bool shared = placement == 0 ? (edge.x == 5 && edge.y == 7) || (edge.x == 7 && edge.y == 5)
                                               : (edge.x == 4 && edge.y == 6) || (edge.x == 6 && edge.y == 4);
            if (!shared) continue;
            const auto [all, visible] = drawing.length_of(e, placement);
            EXPECT_NEAR(visible, all, 0.13);
            ++tops;
        }
    EXPECT_EQ(tops, 2);
}

TEST(Exact, TheNearPlaneCutsOccludersOpen) {
    // A wall along the view at x = .2, from behind the viewer to distance 3. A point x of the wire at distance 6 is
    // seen through the wall at distance 1.2 / x: hidden where that lies between the near plane (1) and 3.
    const View view = camera(1.0);
    const Mesh wall = rectangle({0.2f, -9, 1}, {0.2f, 9, 1}, {0.2f, 9, -3}, {0.2f, -9, -3});
    const auto found = changes({{-1, 0, -6}, {3, 0, -6}}, view, {place(wall)});
    ASSERT_EQ(found.size(), 2u);
    EXPECT_NEAR(found[0], pixel_of(view, {0.4, 0, -6}).x, exact_tolerance_px + 0.02);
    EXPECT_NEAR(found[1], pixel_of(view, {1.2, 0, -6}).x, exact_tolerance_px + 0.02);
}

TEST(Exact, FromInsideABoxItsEdgesAreSeen) {
    const View view = perspective({-0.8, -0.8, -0.2}, {1, 1, 0.1}, 18);
    const Drawing drawing({place(box()), place(box(vec3(-3), vec3(3)), dmat4(1.0), 2)}, view, {all_edges()});
    EXPECT_GT(drawing.total_px(0), 300.0);
    EXPECT_NEAR(drawing.visible_px(0), drawing.total_px(0), 1e-6);
    EXPECT_EQ(drawing.visible_px(1), 0.0) << "the larger box is outside of the smaller one";
}
