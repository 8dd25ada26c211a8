// SPDX-License-Identifier: GPL-3.0-or-later
// Haloes: how far from what they pass behind lines stop.
#include <cmath>
#include <gtest/gtest.h>
#include <numbers>

#include "line_filters.h"

using namespace fovea;
using namespace fovea::draw;
using namespace fovea::line_filters;

namespace {

constexpr double radians = std::numbers::pi / 180.0;

/// A horizontal line far away, and one before it that crosses it in the middle at an angle; both 200 px long.
std::vector<std::vector<dvec3>> crossing(double degrees, double far = 4.0, double near = 3.0, int segments = 1) {
    const dvec2 way = 100.0 * dvec2(std::cos(degrees * radians), std::sin(degrees * radians));
    return {divided(at(100, 200, far), at(300, 200, far), segments),
            divided(at(200 - way.x, 200 - way.y, near), at(200 + way.x, 200 + way.y, near), segments)};
}

Runs with_gap(const ClippedPaths& clipped, float gap) {
    return halo(clipped, whole(clipped), everywhere(clipped, gap));
}

}  // namespace

TEST(Halo, LeavesLinesThatTurnAwayOnTheirOwnSurface) {
    // The lower rim of a can goes out of sight behind it, where its outline begins; nothing is behind anything.
    const meshes::Mesh can = meshes::cylinder(24);
    const LineSet lines = drawing::line_set({"contour", "border"});
    for (double height : {0.5, 2.0, 4.0}) {
        const View view = drawing::perspective({0.3, -7, height}, {0, 0, 0});
        const drawing::Drawing drawn({drawing::place(can)}, view, {lines});
        EXPECT_GT(drawn.runs.size(), 3u);
        expect_same(halo(drawn.clipped, drawn.runs, everywhere(drawn.clipped, 6)), drawn.runs);
        // One before it hides some of it.
        const dmat4 nearer = glm::translate(dmat4(1.0), dvec3(0.9, -2.5, 0.1));
        const drawing::Drawing two({drawing::place(can), drawing::place(can, nearer, 2)}, view, {lines});
        const Runs apart = halo(two.clipped, two.runs, everywhere(two.clipped, 6));
        EXPECT_LT(visible_length(apart), visible_length(two.runs) - 12.0) << height;
        EXPECT_GT(visible_length(apart), visible_length(two.runs) - 100.0) << height;
    }
}

TEST(Halo, ContoursDoNotStopShortOfLinesThatTheyGraze) {
    const ClippedPaths clipped = Wires(crossing(90)).project(camera());
    Runs runs = whole(clipped);
    runs.end_px[0] = 60.0;  // hidden from there on, by nothing that is drawn
    const std::vector<std::uint8_t> of_view{2, 0};
    const std::vector<Part> expected{{0, -100, -5}, {0, 5, 60}, {1, -100, 100}};
    expect_runs(halo(clipped, runs, everywhere(clipped, 5), of_view), expected, 0.02);
    expect_runs(halo(clipped, runs, everywhere(clipped, 5)), expected, 0.02);
    EXPECT_THROW(halo(clipped, runs, everywhere(clipped, 5), std::vector<std::uint8_t>{1}), std::invalid_argument);
    const ClippedPaths grazing = Wires(crossing(10)).project(camera());
    expect_same(halo(grazing, whole(grazing), everywhere(grazing, 5), of_view), whole(grazing));
    EXPECT_GT(with_gap(grazing, 5).size(), 2u);
}

TEST(Halo, StaysOffTheFrame) {
    const ClippedPaths clipped = Wires({{at(-100, 100), at(900, 100)}}).project(camera());
    expect_same(with_gap(clipped, 5), whole(clipped));
}

TEST(Halo, AtATJunctionTheGapIsAsWideAsAsked) {
    // A plate whose right edge stands at x = 200, drawn as a line, hides the left half of a line behind it.
    meshes::Mesh plate("plate", {});
    for (const auto& [x, y] : {std::pair(50, 50), {200, 50}, {200, 350}, {50, 350}})
        plate.positions.push_back(vec3(at(x, y, 3)));
    plate.add_polygon({0, 1, 2, 3});
    for (double degrees : {90.0, 45.0}) {
        const double lean = 150.0 / std::tan(degrees * radians);
        const Wires wires({{at(100, 200), at(300, 200)}, {at(200 - lean, 50, 3), at(200 + lean, 350, 3)}}, dmat4(1.0),
                          {drawing::place(plate)});
        const View view = camera();
        const ClippedPaths clipped = wires.project(view);
        const Tracer tracer(wires.scene, view);
        const Runs visible = exact_visibility(clipped, wires.paths, tracer, Cancel());
        ASSERT_NEAR(visible.start_px[0], 0.0, exact_tolerance_px);
        const Runs haloed = halo(clipped, visible, everywhere(clipped, 6));
        EXPECT_NEAR(haloed.start_px[0], 6.0 / std::sin(degrees * radians), exact_tolerance_px)
            << "across the nearer line";
        EXPECT_NEAR(haloed.end_px[0], 100.0, 1e-3);
        EXPECT_EQ(haloed.start_px[1], visible.start_px[1]) << "the nearer line is whole";
        EXPECT_EQ(haloed.end_px[1], visible.end_px[1]);
    }
}

TEST(Halo, ACrossingLeavesTheGapOnBothSidesOfTheNearerLine) {
    for (double degrees : {90.0, 60.0, 30.0, 120.0, 5.0}) {
        const double along = 4.0 / std::max(std::abs(std::sin(degrees * radians)), std::sin(15.0 * radians));
        for (int segments : {1, 7, 90}) {
            const ClippedPaths clipped = Wires(crossing(degrees, 4.0, 3.0, segments)).project(camera());
            expect_runs(with_gap(clipped, 4), {{0, -100, -along}, {0, along, 100}, {1, -100, 100}}, 0.02);
        }
    }
    const ClippedPaths behind = Wires(crossing(90, 3.0, 4.0)).project(camera());
    expect_runs(with_gap(behind, 4), {{0, -100, 100}, {1, -100, -4}, {1, 4, 100}}, 0.02);
    const ClippedPaths one = Wires(crossing(90)).project(camera());
    expect_runs(halo(one, whole(one), std::vector<float>{0, 4}), {{0, -100, 100}, {1, -100, 100}}, 0.02);
}

TEST(Halo, IsTheSameAtAnyScaleAndForOrthographicCameras) {
    for (double scale : {1e-3, 1.0, 1e3}) {
        View view = camera(0.1 * scale);
        view.far_clip *= scale;
        auto lines = crossing(90);
        for (auto& line : lines)
            for (dvec3& point : line) point *= scale;
        const ClippedPaths clipped = Wires(lines).project(view);
        expect_runs(with_gap(clipped, 4), {{0, -100, -4}, {0, 4, 100}, {1, -100, 100}}, 0.02);
    }
    View view = camera(0.1, true);
    view.view_to_clip = glm::ortho(-3.2, 3.2, -2.4, 2.4, view.near_clip, view.far_clip);
    const ClippedPaths clipped = Wires({{{-1, 0, -4}, {1, 0, -4}}, {{0, -1, -3}, {0, 1, -3}}}).project(view);
    expect_runs(with_gap(clipped, 4), {{0, -100, -4}, {0, 4, 100}, {1, -100, 100}}, 0.02);
}

TEST(Halo, LinesThatMeetAreNotBehindEachOther) {
    for (double near : {4.0, 3.999, 3.93}) {  // a pixel is 0.01 there
        const ClippedPaths clipped = Wires(crossing(60, 4.0, near, 9)).project(camera());
        expect_same(with_gap(clipped, 4), whole(clipped));  // on the same surface
    }
    EXPECT_EQ(with_gap(Wires(crossing(60, 4.0, 3.91, 9)).project(camera()), 4).size(), 3u) << "nine pixels before it";
    const dvec3 corner = at(200, 200, 3);
    const ClippedPaths star =
        Wires({{corner, at(300, 210, 2)}, {corner, at(300, 212, 6)}, {at(300, 205, 5), corner}}).project(camera());
    expect_same(with_gap(star, 4), whole(star));  // at a common corner
    std::vector<dvec3> spiral;
    for (int i = 0; i < 400; ++i)
        spiral.push_back(at(320 + 0.5 * i * std::cos(0.1 * i), 240 + 0.5 * i * std::sin(0.1 * i), 4 - 0.005 * i));
    const ClippedPaths winding = Wires({spiral}).project(camera());
    expect_same(with_gap(winding, 4), whole(winding));  // beside itself
}

TEST(Halo, ALineMayPassBehindItself) {
    const ClippedPaths knot =
        Wires({{at(100, 200, 4), at(300, 200, 4), at(300, 100, 4), at(200, 100, 3), at(200, 300, 3)}})
            .project(camera());
    const double start = knot.arc_px[0];
    expect_runs(with_gap(knot, 4), {{0, start, start + 96}, {0, start + 104, knot.arc_px[4]}}, 0.1);
}

TEST(Halo, CrossesTheSeamOfARing) {
    std::vector<dvec3> square{at(200, 200), at(300, 200), at(300, 300), at(200, 300), at(200, 200)};
    const ClippedPaths clipped =
        Wires({square, {at(150, 198, 3), at(250, 198.1, 3)}, {at(201, 150, 3), at(201, 250, 3)}}).project(camera());
    ASSERT_TRUE(clipped.closed[0]);
    const double first = clipped.arc_px[0], last = clipped.arc_px[4];
    expect_runs(halo(clipped, whole(clipped), std::vector<float>{4, 0, 0}),
                {{0, first + 5, last - 3}, {1, -50, 50}, {2, -50, 50}}, 0.02);
}

TEST(Halo, GrowsWithItsGapAndOnlyVisibleLinesMakeOne) {
    std::vector<std::vector<dvec3>> lines;
    std::mt19937 random(5);
    std::uniform_real_distribution<double> x(0, 640), y(0, 480), depth(2, 9);
    for (int k = 0; k < 60; ++k)
        lines.push_back({at(x(random), y(random), depth(random)), at(x(random), y(random), depth(random))});
    const ClippedPaths clipped = Wires(lines).project(camera());
    const Runs runs = whole(clipped);
    Runs less = runs;
    for (float gap : {0.01f, 1.0f, 1.1f, 5.0f, 30.0f}) {
        const Runs more = halo(clipped, runs, everywhere(clipped, gap));
        expect_sound(more);
        EXPECT_TRUE(holds(less, more)) << gap;
        less = more;
    }
    EXPECT_LT(visible_length(halo(clipped, runs, everywhere(clipped, 1.0f))), 0.99 * visible_length(runs));
    Runs hidden = runs;
    for (auto& by : hidden.invisibility) by = 1;
    expect_same(halo(clipped, hidden, everywhere(clipped, 5)), hidden);
    // Only the first line is visible: nothing is before it.
    hidden.invisibility[0] = 0;
    EXPECT_EQ(visible_length(halo(clipped, hidden, everywhere(clipped, 5))), visible_length(hidden));
}

TEST(Halo, FindsEveryCrossingOfManyLines) {
    // A net of threads, the vertical ones before the others: each cell of the grid holds some of it.
    std::vector<std::vector<dvec3>> lines;
    for (int k = 0; k < 20; ++k) lines.push_back(divided(at(10, 20 + 22 * k, 4), at(630, 20 + 22 * k, 4), 1 + 5 * k));
    for (int k = 0; k < 30; ++k)
        lines.push_back(divided(at(20 + 20.5 * k, 5, 3), at(20 + 20.5 * k, 470, 3), 1 + 9 * k));
    const ClippedPaths clipped = Wires(lines).project(camera());
    const Runs runs = with_gap(clipped, 2);
    EXPECT_EQ(runs.size(), 20u * 31u + 30u);
    EXPECT_NEAR(visible_length(runs), visible_length(whole(clipped)) - 20 * 30 * 4, 1.0);
}
