// SPDX-License-Identifier: GPL-3.0-or-later
// Very many lines, or triangles, in one place: what is looked at, counted, does not grow with the square of their
// number, and the result is that of a few.
#include <gtest/gtest.h>

#include <fovea/runs/ends_by_cell.h>
#include <fovea/runs/stretch_grid.h>
#include <fovea/scene/triangle_tree.h>
#include <fovea/visibility/crowds.h>

#include "elision_fixture.h"
#include "intersections.h"
#include "line_filters.h"

using namespace fovea;
using namespace fovea::draw;

namespace {

/// A corner of two lines, each `count` times at the same place, and one line before them through both.
Array<Stretch> corner(int count) {
    Array<Stretch> stretches;
    for (int i = 0; i < count; ++i) {
        const auto point = Index(stretches.size());
        stretches.push_back({{10, 10}, {90, 20}, point, 5.0f});
        stretches.push_back({{90, 20}, {40, 80}, point + 1, 5.0f - float(i) / float(count)});
    }
    stretches.push_back({{0, 60}, {100, 0}, Index(stretches.size()), 3.0f});
    return stretches;
}

/// Number of stretches looked at beside each of a corner.
std::size_t tests_of(int count) {
    const Array<Stretch> stretches = corner(count);
    const StretchGrid grid{Array<Stretch>(stretches)};
    std::size_t tests = 0;
    for (const Stretch& stretch : stretches) grid.near(stretch.a, stretch.b, [&](const Stretch&) { ++tests; });
    return tests;
}

}  // namespace

TEST(Crowds, OfStretchesInOnePlaceTestsGrowAsTheirNumber) {
    const std::size_t thousand = tests_of(1000), many = tests_of(8000);
    EXPECT_LT(many, 9 * thousand);
    EXPECT_LT(thousand, 100u * 2001u);
}

TEST(Crowds, OfStretchesInOnePlaceTheNearestIsFound) {
    const StretchGrid grid(corner(2000));
    float nearest = 9.0f;
    bool before = false;
    grid.near({60, 40}, {80, 50}, [&](const Stretch& stretch) {
        if (stretch.a == vec2(90, 20)) nearest = std::min(nearest, stretch.distance);
    });
    grid.near({10, 20}, {40, 60}, [&](const Stretch& stretch) { before |= stretch.distance == 3.0f; });
    EXPECT_NEAR(nearest, 4.0f, 0.001f);
    EXPECT_TRUE(before);
}

TEST(Crowds, OfLinesHaveTheHaloesOfOne) {
    using namespace line_filters;
    const std::vector<dvec3> behind{at(100, 200, 4), at(300, 210, 4)}, before{at(200, 100, 3), at(210, 300, 3)};
    const auto with_gaps = [&](int count) {
        std::vector<std::vector<dvec3>> lines{behind};
        for (int i = 0; i < count; ++i) lines.push_back(before);
        const ClippedPaths clipped = Wires(lines).project(camera());
        return halo(clipped, whole(clipped), everywhere(clipped, 5));
    };
    const Runs one = with_gaps(1), many = with_gaps(3000);
    ASSERT_EQ(one.piece[1], 0u) << "in two parts";
    for (int r = 0; r < 2; ++r) {
        EXPECT_EQ(many.start_px[r], one.start_px[r]);
        EXPECT_EQ(many.end_px[r], one.end_px[r]);
    }
    EXPECT_EQ(many.size(), 3002u);
}

TEST(Crowds, OfEndsAreTwoOfEachPlaceAndDirection) {
    using namespace line_filters;
    const auto ends = [](int count, double spread) {
        std::vector<std::vector<dvec3>> lines;
        for (int i = 0; i < count; ++i) {
            const double off = spread * i / count;
            lines.push_back({at(100.3 + off, 100.3), at(160.3, 130.3 + off)});
        }
        const ClippedPaths clipped = Wires(lines).project(camera());
        const std::vector<Index> placement(lines.size(), 0);
        return ends_by_cell(clipped, whole(clipped), placement, 8.0);
    };
    EXPECT_EQ(ends(1, 0.0).size(), 2u);
    EXPECT_EQ(ends(2, 0.0).size(), 4u);
    EXPECT_EQ(ends(5000, 0.0).size(), 4u);
    EXPECT_EQ(ends(200, 1e-2).size(), 400u) << "no crowd: all are told apart";
    EXPECT_LT(ends(5000, 1e-2).size(), 20u);
}

TEST(Crowds, OfContoursMeetTheEndsThatOneMeets) {
    using namespace line_filters;
    const auto met = [](int count) {
        std::vector<std::vector<dvec3>> lines{{at(100, 100), at(200, 100)}};
        for (int i = 0; i < count; ++i) lines.push_back({at(196, 101), at(300, 101)});
        const ClippedPaths clipped = Wires(lines).project(camera());
        Runs runs = whole(clipped);
        runs.end_px[0] = 40.0;
        const std::vector<std::uint8_t> of_view(lines.size(), 1);
        const std::vector<Index> placement(lines.size(), 0);
        return meet_ends(clipped, runs, of_view, placement, 8.0).end_px[0];
    };
    EXPECT_GT(met(1), 45.0);
    EXPECT_EQ(met(1000), met(1));
}

TEST(Crowds, OfBandsFillTheBufferAsSixteenDo) {
    const auto sheet_of = [](int count) {
        Sheet sheet;
        for (int i = 0; i < count; ++i) sheet.line({{20, 80}, {90, 80.25f}, {180, 60}});
        sheet.line({{100, 20}, {100, 140}});
        return sheet;
    };
    const Sheet some = sheet_of(16), many = sheet_of(1000);
    const auto triangles = [](const Sheet& sheet) {
        return draw_bands(sheet.clipped, sheet.runs, sheet.ranks(), sheet.own()).triangles.size();
    };
    EXPECT_EQ(triangles(many), triangles(some));
    const PriorityBuffer of_some = some.buffer(some.own()), of_many = many.buffer(many.own());
    for (std::size_t i = 0; i < of_some.first.size(); ++i) {
        ASSERT_EQ(of_many.first[i].coverage, of_some.first[i].coverage) << i;
        ASSERT_EQ(of_many.first[i].crossed, of_some.first[i].crossed) << i;
    }
}

TEST(Crowds, OfTrianglesInOnePlaceMeetOthersOnce) {
    using namespace intersections;
    const auto stack = [](int count) {
        Mesh mesh("stack", {});
        const vec3 quad[] = {{-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0}},
                   wall[] = {{0, -2, -1}, {0, 2, -1}, {0, 0, 2}};
        for (int i = 0; i < count; ++i) {
            const int first = int(mesh.positions.size());
            mesh.positions.insert(mesh.positions.end(), std::begin(quad), std::end(quad));
            if (i % 2)
                mesh.add_polygon({first, first + 1, first + 2, first + 3});
            else
                mesh.add_polygon({first, first + 3, first + 2, first + 1});
        }
        const int first = int(mesh.positions.size());
        mesh.positions.insert(mesh.positions.end(), std::begin(wall), std::end(wall));
        mesh.add_polygon({first, first + 1, first + 2});
        return mesh;
    };
    EXPECT_LE(triangle_tree(*stack(3000).surface())->order.size(), 2 * 16u + 9u);
    const Found one({place(stack(1))}), many({place(stack(3000))});
    EXPECT_EQ(one.count, 1u);
    EXPECT_EQ(many.count, 1u);
    EXPECT_NEAR(many.length, one.length, 1e-6);
}

TEST(Crowds, OfSolidsInOnePlaceAreSeenAsOneIs) {
    // Boxes in one place, or a millionth apart, half behind a wall.
    const auto drawn = [](int count, double apart) {
        std::vector<Placement> all{drawing::place(meshes::box({0, -3, -3}, {3, -2, 3}), dmat4(1.0), 9)};
        for (int i = 0; i < count; ++i) {
            const double off = apart * i / count;
            all.push_back(drawing::place(meshes::box(), drawing::moved({off, -off, off}), std::uint64_t(10 + i)));
        }
        return drawing::Drawing(std::move(all), drawing::perspective({-1, -9, 4}, {0, 0, 0}),
                                {drawing::line_set({"crease"})});
    };
    const auto one = drawn(1, 0.0);
    EXPECT_TRUE(first_of_crowds(one.clipped, one.paths, one.tracer).empty());
    for (const double apart : {0.0, 1e-6}) {
        const auto many = drawn(40, apart);
        const Array<Index> first = first_of_crowds(many.clipped, many.paths, many.tracer);
        ASSERT_EQ(first.size(), many.clipped.path.size());
        const std::set<Index> asked(first.begin(), first.end());
        EXPECT_LT(asked.size(), apart == 0.0 ? 25u : 60u) << "of 12 edges each";
        for (Index placement = 1; placement <= 40; ++placement) {
            EXPECT_NEAR(many.total_px(placement), one.total_px(1), 1e-3);
            EXPECT_NEAR(many.visible_px(placement), one.visible_px(1), 12 * 2 * exact_tolerance_px) << placement;
        }
    }
}

TEST(Crowds, OfLinesOnSurfacesOfOtherDirectionsAreSeenEachByItself) {
    // Flaps around one axis, like the pages of a book that stands open: their common edge is one line of each.
    std::vector<Placement> flaps;
    for (int i = 0; i < 40; ++i) {
        const dmat4 turned = glm::rotate(dmat4(1.0), 0.1 * i, dvec3(0, 0, 1));
        flaps.push_back(
            drawing::place(meshes::of_polygons("flap", {{0, 0, 0}, {1, 0, 0}, {1, 0, 1}, {0, 0, 1}}, {{0, 1, 2, 3}}),
                           turned, std::uint64_t(i)));
    }
    const drawing::Drawing book(std::move(flaps), drawing::perspective({0.5, -4, 3}, {0, 0, 0}),
                                {drawing::line_set({"border"})});
    EXPECT_TRUE(first_of_crowds(book.clipped, book.paths, book.tracer).empty());
}

TEST(Crowds, AreMoreThanSixteenAlike) {
    const auto first_of = [](int count) {
        const drawing::Drawing sheets(std::vector(std::size_t(count), drawing::place(meshes::grid(1))),
                                      drawing::perspective({0.5, -4, 3}, {0, 0, 0}), {drawing::line_set({"border"})});
        EXPECT_EQ(sheets.clipped.path.size(), 4u * count);
        const Array<Index> first = first_of_crowds(sheets.clipped, sheets.paths, sheets.tracer);
        return std::set<Index>(first.begin(), first.end()).size();
    };
    EXPECT_EQ(first_of(16), 0u);
    EXPECT_EQ(first_of(17), 4u);
}

TEST(Crowds, OfLinesThatBeginInOnePlaceAreSeenEachByItself) {
    // A fan of blades in one plane.
    std::vector<Placement> blades;
    for (int i = 0; i < 40; ++i)
        blades.push_back(drawing::place(meshes::of_polygons("blade", {{0, 0, 0}, {1, 0, 0}, {1, 0.05, 0}}, {{0, 1, 2}}),
                                        glm::rotate(dmat4(1.0), 0.15 * i, dvec3(0, 0, 1)), std::uint64_t(i)));
    const View view = drawing::perspective({0.5, -4, 3}, {0, 0, 0});
    const drawing::Drawing fan(std::move(blades), view, {drawing::line_set({"border"})});
    const dvec2 middle = drawing::pixel_of(view, dvec3(0.0));
    int there = 0;
    for (Index q = 0; q < fan.clipped.path.size(); ++q)
        there += glm::distance(dvec2(fan.clipped.px[fan.clipped.pieces.begin(q)]), middle) < 1e-3;
    EXPECT_EQ(there, 40);
    EXPECT_TRUE(first_of_crowds(fan.clipped, fan.paths, fan.tracer).empty());
}
