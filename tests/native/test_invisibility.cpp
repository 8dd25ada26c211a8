// SPDX-License-Identifier: GPL-3.0-or-later
// Quantitative invisibility where the number of surfaces is known.
#include <gtest/gtest.h>
#include <numeric>

#include "counted.h"

using namespace fovea;
using namespace fovea::draw;
using namespace fovea::meshes;
using namespace fovea::drawing;
using namespace fovea::wires;

namespace {

/// A plane that faces the camera at `distance`, from x = left to the right border and beyond.
Mesh plane_from(double left, double distance) {
    const float d = static_cast<float>(-distance), x = static_cast<float>(left);
    return of_polygons("plane", {{x, -90, d}, {90, -90, d}, {90, 90, d}, {x, 90, d}}, {{0, 1, 2, 3}});
}

/// Lines across the frame at `distance`, `n` of them.
std::vector<std::vector<dvec3>> lines_across(int n, double distance, double half) {
    std::vector<std::vector<dvec3>> lines;
    for (int i = 0; i < n; ++i) {
        const double y = half * 0.7 * (2.0 * i / (n - 1) - 1.0);
        lines.push_back({{-half, y, -distance}, {half, y + 0.05 * half, -distance}});
    }
    return lines;
}

}  // namespace

TEST(Invisibility, StackedPlanesCountFromZeroToTheirNumber) {
    for (const bool ortho : {false, true})
        for (int n = 1; n <= 6; ++n) {
            const View view = camera(0.1, ortho);
            const double distance = 20.0, half = ortho ? 0.7 : 0.7 * distance;
            std::vector<Placement> planes;
            std::vector<double> edges_px;  // where each begins to hide
            for (int k = 0; k < n; ++k) {
                const double d = 3.0 + 2.1 * k, left = (ortho ? 1.0 : d) * (-0.5 + 0.17 * k + 0.0123);
                planes.push_back(place(plane_from(left, d), dmat4(1.0), 10 + k));
                edges_px.push_back(pixel_of(view, {left, 0, -d}).x);
            }
            const Wires wires(lines_across(9, distance, half), dmat4(1.0), planes);
            const Counted counted(wires, view, 255);
            ASSERT_EQ(counted.clipped.pieces.count(), 9u);
            for (Index q = 0; q < 9; ++q) {
                std::vector<int> expected(n + 1);
                std::iota(expected.begin(), expected.end(), 0);
                ASSERT_EQ(counted.numbers(q), expected) << n << " planes" << (ortho ? " ortho" : "");
                for (int k = 0; k < n; ++k)
                    EXPECT_NEAR(counted.changes(q)[k].x, edges_px[k], exact_tolerance_px + 1e-3);
            }
        }
}

TEST(Invisibility, NumbersAreToldApartUpToTheLevels) {
    const View view = camera();
    std::vector<Placement> planes;
    for (int k = 0; k < 5; ++k)
        planes.push_back(place(plane_from((3.0 + k) * (-0.5 + 0.2 * k), 3.0 + k), dmat4(1.0), 10 + k));
    const Wires wires(lines_across(3, 12, 8), dmat4(1.0), planes);
    const Counted full(wires, view, 255);
    ASSERT_EQ(full.numbers(), (std::vector{0, 1, 2, 3, 4, 5}));
    for (Index levels = 0; levels <= 6; ++levels) {
        const Counted counted(wires, view, levels);
        std::vector<int> expected;
        for (int k = 0; k <= std::min(5, std::max(1, int(levels))); ++k) expected.push_back(k);
        EXPECT_EQ(counted.numbers(), expected);
        for (std::size_t i = 0; i < counted.changes().size(); ++i)
            EXPECT_NEAR(counted.changes()[i].x, full.changes()[i].x, 1e-9) << "the same places";
    }
}

TEST(Invisibility, ASphereHidesItsChordOnce) {
    const double radius = 1.5, depth = 6.0;
    const int n = 192;
    for (const bool ortho : {false, true}) {
        const View view = camera(0.1, ortho);
        const double size = ortho ? 0.4 : radius, half = ortho ? 0.79 : 7.0, distance = 9.0;
        const Wires wires(lines_across(21, distance, half), dmat4(1.0),
                          {place(sphere(n), moved({0, 0, -depth}) * scaled(dvec3(size)), 5)});
        const Counted counted(wires, view, 9);
        // Seen from the origin the sphere's outline is a circle around the middle of the frame.
        const double at_1 = ortho ? size : size / std::sqrt(depth * depth - size * size);
        const double outline_px = 320.0 / 0.8 * at_1;
        int crossed = 0;
        for (Index q = 0; q < 21; ++q) {
            const Index first = first_of(counted.clipped, q), last = last_of(counted.clipped, q);
            const dvec2 a = dvec2(counted.clipped.px[first]) - dvec2(320, 240),
                        way = dvec2(counted.clipped.px[last]) - dvec2(320, 240) - a;
            const dvec2 along = glm::normalize(way);
            const double foot = -glm::dot(a, along), beside = glm::length(a + foot * along);
            if (std::abs(beside - outline_px) < 1.0) continue;
            if (beside > outline_px) {
                EXPECT_EQ(counted.numbers(q), (std::vector{0}));
                continue;
            }
            ASSERT_EQ(counted.numbers(q), (std::vector{0, 1, 0})) << q;
            const double chord = std::sqrt(outline_px * outline_px - beside * beside);
            // The mesh lies inside the sphere by (1 - cos(pi / 2n)) of its size; near the rim that is more along the
            // line.
            const double inside = outline_px * (1.0 - std::cos(std::numbers::pi / n)) * outline_px / chord;
            for (int end = 0; end < 2; ++end) {
                const double expected = foot + (end ? chord : -chord);
                const double found = glm::dot(counted.changes(q)[end] - dvec2(320, 240) - a, along);
                EXPECT_NEAR(found, expected, exact_tolerance_px + 1e-2 + inside);
            }
            ++crossed;
        }
        EXPECT_GT(crossed, 5);
    }
}

TEST(Invisibility, OfABoxItsOwnBackEdgesAreHiddenOnce) {
    for (const View& view : {perspective({4, -5, 3}, {0, 0, 0}), orthographic({4, -5, 3}, {0, 0, 0}, 5)})
        for (const bool turned : {false, true}) {
            const Drawing drawing({place(turned ? flipped(box(), [](int) { return true; }) : box())}, view,
                                  {all_edges()});
            const Counted counted(drawing.scene, drawing.paths, view, 8);
            const auto lengths = counted.lengths();
            EXPECT_EQ(lengths.size(), 2u);
            EXPECT_GT(lengths.at(1), 100.0);
            EXPECT_NEAR(lengths.at(0), drawing.visible_px(0), 1e-6);
        }
}

TEST(Invisibility, SolidsCountOnceAndSheetsForEachCrossing) {
    const View view = perspective({0, -12, 0}, {0, 0, 0}, 36);
    const auto behind = [&](const std::vector<Placement>& others) {
        return Counted(Wires({{{-0.5, 8, 0.11}, {0.5, 8, 0.12}}}, dmat4(1.0), others), view, 20).numbers();
    };
    const Mesh cube = box();
    Mesh open("open box", cube.positions);  // without its top
    for (int f : {0, 2, 3, 4, 5})
        open.add_polygon({cube.corner_verts[4 * f], cube.corner_verts[4 * f + 1], cube.corner_verts[4 * f + 2],
                          cube.corner_verts[4 * f + 3]});
    EXPECT_EQ(behind({place(cube)}), (std::vector{1}));
    EXPECT_EQ(behind({place(cube), place(cube, moved({0, 4, 0}), 2)}), (std::vector{2}));
    EXPECT_EQ(behind({place(cube), place(cube, scaled({-1, 0.5, 0.5}), 2)}), (std::vector{2})) << "one in the other";
    EXPECT_EQ(behind({place(open)}), (std::vector{2})) << "front and back";
    EXPECT_EQ(behind({place(open), place(cube, moved({0, 4, 0}), 2)}), (std::vector{3}));
    EXPECT_EQ(behind({place(flipped(cube, [](int f) { return f == 2; }))}), (std::vector{2}))
        << "not one side is outside";
    Mesh pane = cube;
    pane.occluding = {1, 1, 1, 0, 1, 1};  // the back shows what lies behind
    EXPECT_EQ(behind({place(pane)}), (std::vector{1}));
    // The same three bodies in one mesh.
    Mesh joined("joined", {});
    for (const auto& [mesh, y] :
         std::vector<std::pair<const Mesh*, float>>{{&cube, 0.0f}, {&open, 3.0f}, {&cube, 6.0f}}) {
        const int base = static_cast<int>(joined.positions.size());
        for (const vec3& p : mesh->positions) joined.positions.push_back(p + vec3(0, y, 0));
        for (std::size_t f = 0; f + 1 < mesh->polygon_offsets.size(); ++f) {
            std::vector<int> verts;
            for (int c = mesh->polygon_offsets[f]; c < mesh->polygon_offsets[f + 1]; ++c)
                verts.push_back(base + mesh->corner_verts[c]);
            joined.add_polygon(verts);
        }
    }
    EXPECT_EQ(behind({place(joined)}), (std::vector{4}));
}

TEST(Invisibility, ARayThroughEdgesAndCornersCountsOnce) {
    // Straight at the diagonal, the corners and the sides of a fine grid.
    for (const bool ortho : {false, true}) {
        const View view = camera(0.1, ortho);
        const double half = ortho ? 0.7 : 3.5;
        const Wires wires({{{-half, 0, -8}, {half, 0, -8}},
                           {{-half, -half / 2, -8}, {half, half / 2, -8}},
                           {{0, -half / 2, -8}, {0, half / 2, -8}}},
                          dmat4(1.0),
                          {place(grid(16, 10.0f), moved({0, 0, -4}), 2),
                           place(sphere(32), moved({0, 0, -6}) * scaled(dvec3(9, 9, 1)), 3)});
        const Counted counted(wires, view, 20);
        for (Index q = 0; q < 3; ++q) EXPECT_EQ(counted.numbers(q), (std::vector{2})) << q;
    }
}

TEST(Invisibility, FromInsideARoomAndInsideASolid) {
    const View view = perspective({-0.8, -0.8, -0.2}, {1, 1, 0.1}, 18);
    const Drawing room({place(box()), place(box(vec3(-3), vec3(3)), dmat4(1.0), 2)}, view, {all_edges()});
    const Counted counted(room.scene, room.paths, view, 5);
    for (std::size_t r = 0; r < counted.runs.size(); ++r)
        EXPECT_EQ(counted.runs.invisibility[r], room.paths.placement[counted.clipped.path[counted.runs.piece[r]]])
            << "the room is seen whole, the one around it behind its walls";
    // The eye in one box, a second box before the line: both hide it, as one mesh or two.
    const View inside = perspective({0, 0, 0}, {0, 1, 0}, 36);
    const Wires wires({{{-0.4, 9, 0.1}, {0.4, 9, 0.12}}}, dmat4(1.0),
                      {place(box(), dmat4(1.0), 2), place(box(), moved({0, 5, 0}), 3)});
    EXPECT_EQ(Counted(wires, inside, 5).numbers(), (std::vector{2}));
}

TEST(Invisibility, TheNearPlaneCutsBodiesOpen) {
    // A box from distance 1 to 3 is hollow for a near plane at 2: its back still hides, once.
    const Wires wires({{{-0.5, 0.1, -8}, {0.5, 0.12, -8}}}, dmat4(1.0), {place(box(), moved({0, 0, -2}), 2)});
    for (const bool ortho : {false, true})
        for (const double near_clip : {0.1, 2.0, 2.9})
            EXPECT_EQ(Counted(wires, camera(near_clip, ortho), 5).numbers(), (std::vector{1})) << near_clip;
    EXPECT_EQ(Counted(wires, camera(3.1), 5).numbers(), (std::vector{0}));
}
