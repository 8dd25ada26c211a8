// SPDX-License-Identifier: GPL-3.0-or-later
// Runs read back as polylines: their ends on the line, in the image and in space.
#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <fovea/runs/compaction.h>

#include "line_filters.h"

using namespace fovea;
using namespace fovea::draw;
using namespace fovea::line_filters;

namespace {

/// Place of a point in the image, by the camera.
dvec2 seen_at(const View& view, const vec3& position) {
    return to_pixels(view, view.view_to_clip * dvec4(dvec3(position), 1.0));
}

double distance_to_line(const dvec3& p, const dvec3& a, const dvec3& b) {
    return glm::length(glm::cross(p - a, glm::normalize(b - a)));
}

}  // namespace

TEST(Compaction, EndsLieOnTheLineInSpaceAndInTheImage) {
    for (bool orthographic : {false, true}) {
        const View view = camera(0.1, orthographic);
        const dvec3 a = orthographic ? dvec3(-0.5, 0.1, -3) : at(100, 100, 3),
                    b = orthographic ? dvec3(0.6, 0.2, -9) : at(500, 300, 12);
        Wires wires({divided(a, b, 5)});
        for (int i = 0; i <= 5; ++i) wires.paths.strength[i] = 0.2f * i;
        const ClippedPaths clipped = wires.project(view);
        const double first = clipped.arc_px[0], last = clipped.arc_px[5];
        const Runs runs = runs_of({{0, first, first + 30}, {0, first + 30, last - 9, 2}, {0, last - 9, last}});
        const CompactRuns found = compact(clipped, wires.paths, runs);
        ASSERT_EQ(found.rows.count(), 3u);
        EXPECT_EQ(found.invisibility, runs.invisibility);
        EXPECT_EQ(found.start_px, runs.start_px);
        EXPECT_EQ(found.end_px, runs.end_px);
        ASSERT_EQ(found.px.size(), 6u + 4u) << "the line's points, and two where runs change";
        for (std::size_t i = 0; i < found.px.size(); ++i) {
            EXPECT_LT(glm::length(seen_at(view, found.position_view[i]) - dvec2(found.px[i])), 1e-3) << i;
            const dvec3 position(found.position_view[i]);
            EXPECT_LT(distance_to_line(position, a, b), 1e-5) << i;
            EXPECT_NEAR(found.strength[i], glm::distance(position, a) / glm::distance(a, b), 1e-5)
                << "it is linear in space";
            EXPECT_NEAR(found.arc_px[i] - first, glm::length(found.px[i] - clipped.px[0]), 1e-3) << i;
            EXPECT_EQ(found.kinds[i], 1u);
        }
        EXPECT_EQ(found.px[found.rows.end(0) - 1], found.px[found.rows.begin(1)]) << "runs that touch share their ends";
    }
}

TEST(Compaction, ALineThatEndsEndlesslyFarAwayHasItsEnds) {
    const Wires wires({{{-1.0, 0.2, -64.0}, {2e17, 1e17, -7.76257e17}}});
    const ClippedPaths clipped = wires.project(camera(0.1, false));
    ASSERT_EQ(clipped.px.size(), 2u);
    const double first = clipped.arc_px[0], last = clipped.arc_px[1];
    const Runs runs = runs_of({{0, first, 0.5 * (first + last)}, {0, 0.5 * (first + last), last}});
    for (const vec3& position : compact(clipped, wires.paths, runs).position_view)
        for (int i = 0; i < 3; ++i) EXPECT_TRUE(std::isfinite(position[i]));
}

TEST(Compaction, KindsAreThoseOfTheSegmentFromAPoint) {
    Wires wires({divided(at(100, 100), at(400, 100), 3)});
    for (int i = 0; i < 4; ++i) wires.paths.kinds[i] = Kinds(1) << std::min(i, 2);
    const ClippedPaths clipped = wires.project(camera());
    const CompactRuns found = compact(clipped, wires.paths, runs_of({{0, -120, -60}, {0, -40, 20}, {0, 60, 150}}));
    // Points of the line at -50 and 50.
    EXPECT_EQ(found.kinds, (Array<Kinds>{1, 1, 2, 2, 4, 4}));
}

TEST(Compaction, OfARingIsClosedOnlyWhereItIsWhole) {
    std::vector<dvec3> square{at(200, 200), at(300, 200), at(300, 300), at(200, 300), at(200, 200)};
    const Wires wires({square, {at(10, 10), at(90, 10)}});
    const ClippedPaths clipped = wires.project(camera());
    const double first = clipped.arc_px[0], last = clipped.arc_px[4];
    CompactRuns found = compact(clipped, wires.paths, whole(clipped));
    EXPECT_EQ(found.closed, (Array<std::uint8_t>{1, 0}));
    EXPECT_EQ(found.px[0], found.px[4]);
    EXPECT_EQ(found.path_id, (Array<std::uint64_t>{0, 1}));
    found = compact(clipped, wires.paths, runs_of({{0, first, last - 1}}));
    EXPECT_EQ(found.closed[0], 0);
    ASSERT_EQ(found.px.size(), 5u);
    EXPECT_NEAR(found.px[4].y, 201.0f, 1e-3f);
}

TEST(Compaction, OvershootGoesStraightOnAsFarAwayAsTheEnd) {
    for (bool orthographic : {false, true}) {
        const View view = camera(0.1, orthographic);
        const auto place = [&](double x, double y, double d) {
            return orthographic ? dvec3(0.8 * (x / 320.0 - 1.0), 0.6 * (y / 240.0 - 1.0), -d) : at(x, y, d);
        };
        // Toward the end the line turns away for less than a dense mesh's last step.
        const Wires wires({{place(100, 100, 3), place(300, 100, 5), place(300, 200, 4), place(302, 200, 4)}});
        const ClippedPaths clipped = wires.project(view);
        const Runs runs = overshoot(clipped, whole(clipped), everywhere(clipped, 10));
        const CompactRuns found = compact(clipped, wires.paths, runs);
        ASSERT_EQ(found.px.size(), 6u);
        EXPECT_NEAR(found.px[0].x, 90.0f, 1e-3f);
        EXPECT_NEAR(found.px[0].y, 100.0f, 1e-3f);
        const vec2 way = glm::normalize(vec2(2, 100));
        EXPECT_LT(glm::length(found.px[5] - (vec2(302, 200) + 10.0f * way)), 1e-2f);
        EXPECT_NEAR(found.position_view[0].z, -3.0f, 1e-6f);
        EXPECT_NEAR(found.position_view[5].z, -4.0f, 1e-6f);
        for (std::size_t i = 0; i < 6; ++i)
            EXPECT_LT(glm::length(seen_at(view, found.position_view[i]) - dvec2(found.px[i])), 1e-2) << i;
    }
}

TEST(Compaction, IsInPathOrderForAnyNumberOfThreads) {
    std::vector<std::vector<dvec3>> lines;
    for (int k = 0; k < 2000; ++k) lines.push_back(divided(at(30, 0.2 * k, 3), at(700, 480 - 0.2 * k, 5), 1 + k % 11));
    const Wires wires(lines);
    const ClippedPaths clipped = wires.project(camera());
    std::mt19937 random(4);
    const Runs runs = random_runs(clipped, random);
    const CompactRuns many = compact(clipped, wires.paths, runs);
    ASSERT_EQ(many.path.size(), runs.size());
    EXPECT_TRUE(std::ranges::is_sorted(many.path));
    for (Index r = 0; r < many.rows.count(); ++r) {
        ASSERT_GE(many.rows.size(r), 2u);
        const auto begin = many.arc_px.begin() + many.rows.begin(r), end = many.arc_px.begin() + many.rows.end(r);
        EXPECT_EQ(*begin, runs.start_px[r]);
        EXPECT_EQ(end[-1], runs.end_px[r]);
        EXPECT_TRUE(std::is_sorted(begin, end));
    }
    tbb::global_control one(tbb::global_control::max_allowed_parallelism, 1);
    const CompactRuns single = compact(clipped, wires.paths, runs);
    EXPECT_EQ(many.px, single.px);
    EXPECT_EQ(many.position_view, single.position_view);
    EXPECT_EQ(many.strength, single.strength);
    EXPECT_EQ(many.rows.offsets, single.rows.offsets);
    EXPECT_EQ(compact({}, {}, {}).px.size(), 0u);
}
