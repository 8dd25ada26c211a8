// SPDX-License-Identifier: GPL-3.0-or-later
// Projection: samples, their layout, arc length.
#include <cstring>
#include <gtest/gtest.h>
#include <limits>
#include <random>
#include <tbb/global_control.h>

#include <fovea/project/project.h>

#include "wires.h"

using namespace fovea;
using namespace fovea::draw;
using namespace fovea::wires;

namespace {

/// A point at distance 4 that falls on a pixel of camera().
dvec3 at_px(double x, double y) { return {(x / 320.0 - 1.0) * 3.2, (y / 240.0 - 1.0) * 2.4, -4.0}; }

/// A wavy path through space, partly outside of the frame and behind the viewer.
std::vector<dvec3> wave(int points) {
    std::vector<dvec3> line;
    for (int i = 0; i < points; ++i) {
        const double t = double(i) / (points - 1);
        line.push_back({6.0 * t - 3.0, 0.8 * std::sin(9.0 * t), -4.5 + 5.0 * t * t});
    }
    return line;
}

/// Arc length by place on the path: source + source_t of points at path points.
std::map<Index, double> arc_at_points(const ClippedPaths& clipped) {
    std::map<Index, double> arcs;
    for (Index i = 0; i < clipped.px.size(); ++i)
        if (clipped.source_t[i] == 0.0f) arcs[clipped.source[i]] = clipped.arc_px[i];
    return arcs;
}

}  // namespace

TEST(Project, SamplesAreTheLengthOverTheStepRoundedUp) {
    for (const double step : {0.5, 1.0, 2.0, 3.7})
        for (const double length : {10.25, 98.7, 100.1, 399.3}) {
            const ClippedPaths clipped =
                project_line({at_px(50, 100), at_px(50 + length, 100)}, camera(), {.sample_step_px = step});
            ASSERT_EQ(clipped.px.size(), 2u);
            EXPECT_NEAR(clipped.arc_px[1] - clipped.arc_px[0], length, 1e-3);
            EXPECT_EQ(clipped.sample_count[0], Index(std::ceil(length / step))) << length << " / " << step;
            EXPECT_EQ(clipped.sample_count[1], 0u) << "the last point starts no segment";
        }
}

TEST(Project, SamplesOfPiecesFollowEachOther) {
    std::mt19937 random(5);
    std::uniform_real_distribution<double> x(-100, 740), y(-100, 580);
    std::vector<std::vector<dvec3>> lines;
    for (int k = 0; k < 2000; ++k) {
        std::vector<dvec3> line{at_px(x(random), y(random))};
        for (int i = 0; i < k % 5; ++i) line.push_back(line.back() + dvec3(0.2, 0.01 * (k % 50) - 0.2, 0));
        lines.push_back(line);
    }
    const ClippedPaths clipped = Wires(lines).project(camera());
    Index next = 0;
    for (Index q = 0; q < clipped.pieces.count(); ++q) {
        Index samples = 0;
        for (Index i = first_of(clipped, q); i <= last_of(clipped, q); ++i) samples += clipped.sample_count[i];
        ASSERT_GT(samples, 0u);
        for (Index i = first_of(clipped, q); i <= last_of(clipped, q); ++i) {
            EXPECT_EQ(clipped.sample_start[i], next);
            next += clipped.sample_count[i];
        }
        if (q > 0) {
            EXPECT_LE(clipped.path[q - 1], clipped.path[q]);
        }
    }
    EXPECT_EQ(clipped.samples, next);
    EXPECT_GT(clipped.pieces.count(), 1000u);
}

TEST(Project, ASingleSampleIsDroppedUnlessPartOfAPath) {
    const View view = camera();
    EXPECT_EQ(project_line({at_px(100, 100), at_px(101.9, 100)}, view).pieces.count(), 0u);
    EXPECT_EQ(project_line({at_px(100, 100), at_px(102.1, 100)}, view).pieces.count(), 1u);
    const ClippedPaths path = project_line({at_px(100, 100), at_px(101, 100), at_px(102, 101)}, view);
    ASSERT_EQ(path.pieces.count(), 1u);
    EXPECT_EQ(path.sample_count[0] + path.sample_count[1], 2u);
}

TEST(Project, ContoursThatEncloseAlmostNoAreaAreDroppedUnlessTheyTouchAnother) {
    const dvec3 corner = at_px(100, 100);
    const std::vector<dvec3> sliver{corner, at_px(120, 101), at_px(110, 102), corner};
    const auto pieces = [&](dvec3 other, std::uint8_t of_view, const std::vector<dvec3>& closed) {
        Wires lines({closed, {at_px(20, 90), other, at_px(180, 120)}});
        lines.paths.of_view = {1, of_view};
        return lines.project(camera(), {.least_length_px = {30.0}}).pieces.count();
    };
    EXPECT_EQ(pieces(at_px(100, 104), 1, sliver), 1u);
    EXPECT_EQ(pieces(corner, 1, sliver), 2u);
    EXPECT_EQ(pieces(corner, 0, sliver), 1u) << "no contour";
    EXPECT_EQ(pieces(at_px(100, 104), 1, {corner, at_px(120, 100), at_px(110, 117), corner}), 2u) << "it has an area";
}

TEST(Project, NoneOneAndTwoSegments) {
    const View view = camera();
    EXPECT_EQ(Wires({}).project(view).pieces.count(), 0u);
    EXPECT_EQ(Wires({}).project(view).samples, 0u);
    EXPECT_EQ(Wires({{}, {at_px(5, 5)}}).project(view).pieces.count(), 0u);
    EXPECT_EQ(project_line({at_px(5, 5), at_px(5, 5)}, view).pieces.count(), 0u) << "no length";
    const ClippedPaths two = project_line({at_px(10, 10), at_px(60, 10), at_px(60, 10), at_px(60, 40)}, view);
    ASSERT_EQ(two.pieces.count(), 1u);
    EXPECT_EQ(two.sample_count[1], 0u) << "a segment without length has no sample";
    EXPECT_EQ(two.sample_count[0], 25u);
    EXPECT_EQ(two.sample_count[2], 15u);
}

TEST(Project, ArcLengthIsZeroAtTheMiddleInSpace) {
    // Going away from the viewer: the middle in space lies past the middle in the image.
    const ClippedPaths straight = project_line({{-1, 0, -2}, {1, 0, -8}}, camera());
    const double middle_px = drawing::pixel_of(camera(), {0, 0, -5}).x;
    EXPECT_NEAR(straight.px[0].x - straight.arc_px[0], middle_px, 1e-3);
    EXPECT_NEAR(straight.arc_px[1], straight.px[1].x - middle_px, 1e-3);

    // A middle that is a point of the path, and one in the second of three segments.
    const auto arcs = arc_at_points(project_line({at_px(100, 50), at_px(200, 50), at_px(200, 150)}, camera()));
    EXPECT_NEAR(arcs.at(1), 0.0, 1e-3);
    const auto three =
        arc_at_points(project_line({at_px(100, 50), at_px(150, 50), at_px(350, 50), at_px(360, 50)}, camera()));
    EXPECT_NEAR(three.at(0), -130.0, 1e-3);
    EXPECT_NEAR(three.at(3), 130.0, 1e-3);
}

TEST(Project, ArcLengthDoesNotChangeWhenThePathIsClipped) {
    // The frame is what a render border leaves of a larger one: the same pixels, the same arc length.
    const std::vector<dvec3> line = wave(200);
    const View full = camera(), crop = cropped(full, 250, 100, 450, 420);
    const auto arcs = arc_at_points(project_line(line, full, {.margin = 3.0}));
    const auto seen = arc_at_points(project_line(line, crop, {.margin = 0.0}));
    EXPECT_GT(seen.size(), 20u);
    EXPECT_LT(seen.size(), arcs.size());
    for (const auto& [point, arc] : seen) EXPECT_NEAR(arc, arcs.at(point), 1e-6) << point;
}

TEST(Project, ArcLengthGrowsByThePixelsOfEachSegment) {
    const ClippedPaths clipped = project_line(wave(60), camera());
    ASSERT_GE(clipped.pieces.count(), 1u);
    for (Index q = 0; q < clipped.pieces.count(); ++q)
        for (Index i = first_of(clipped, q); i < last_of(clipped, q); ++i)
            EXPECT_NEAR(clipped.arc_px[i + 1] - clipped.arc_px[i], glm::distance(clipped.px[i], clipped.px[i + 1]),
                        1e-3);
}

TEST(Project, KnowsNoUnits) {
    const std::vector<dvec3> line = wave(50);
    const ClippedPaths expected = project_line(line, camera());
    for (const double unit : {0.001, 1000.0}) {
        std::vector<dvec3> scaled = line;
        for (dvec3& p : scaled) p *= unit;
        View view = camera(0.1 * unit);
        view.far_clip *= unit;
        const ClippedPaths clipped = project_line(scaled, view);
        ASSERT_EQ(clipped.px.size(), expected.px.size());
        for (Index i = 0; i < clipped.px.size(); ++i) {
            EXPECT_LT(glm::distance(clipped.px[i], expected.px[i]), 2e-3f);
            EXPECT_NEAR(clipped.arc_px[i], expected.arc_px[i], 0.02);
            EXPECT_NEAR(clipped.depth[i], expected.depth[i], 1e-5);
            EXPECT_EQ(clipped.source[i], expected.source[i]);
        }
    }
}

TEST(Project, OrthographicIsPerspectiveFromFarAway) {
    const std::vector<dvec3> near_line{{-0.4, 0.2, -1.2}, {0.1, -0.3, -0.9}, {0.5, 0.4, -1.1}};
    const ClippedPaths flat = project_line(near_line, camera(0.1, true));
    const double away = 1e5;
    std::vector<dvec3> far_line = near_line;
    View view = camera(away / 2);
    view.far_clip = 2 * away;
    // Far enough that the frame is as wide there as the orthographic one.
    for (dvec3& p : far_line) p = dvec3(away * p.x, away * p.y, p.z + 1.0 - away);
    const ClippedPaths far = project_line(far_line, view);
    ASSERT_EQ(flat.px.size(), far.px.size());
    for (Index i = 0; i < flat.px.size(); ++i) EXPECT_LT(glm::distance(flat.px[i], far.px[i]), 0.01f);
}

TEST(Project, PlacementsThatAreNoPlaceLeaveNothing) {
    const double not_a_number = std::numeric_limits<double>::quiet_NaN();
    for (const double bad : {not_a_number, double(infinity), 1e300, 1e18, 1e17})
        for (const dmat4& at :
             {drawing::moved({bad, 0, 0}), drawing::moved({0, 0, bad}), drawing::scaled({1, bad, 1}), dmat4(bad)}) {
            const ClippedPaths clipped = Wires({{{-1, 0, -3}, {1, 0.5, -3}}}, at).project(camera());
            for (const vec2& px : clipped.px) EXPECT_TRUE(std::isfinite(px.x) && std::isfinite(px.y));
            for (const double arc : clipped.arc_px) EXPECT_TRUE(std::isfinite(arc));
            EXPECT_LT(clipped.samples, 10000u);
        }
}

TEST(Project, LinesCloseByTheEyeHaveFinitePixels) {
    for (const double near : {1e-9, 1e-6, 1e-5, 1e-4})
        for (const double away : {0.0, 1e-3, 1.0, 1e9}) {
            // From in front of the eye to behind it, past it by nearly nothing.
            const ClippedPaths clipped =
                project_line({{0.1, 0.05, -2}, {1e-12, 0, -near}, {away, away, 5}}, camera(near));
            EXPECT_GT(clipped.samples, 0u);
            for (const double arc : clipped.arc_px) EXPECT_TRUE(std::isfinite(arc));
            for (const double length : clipped.path_length_px) EXPECT_LT(length, 1e10);
        }
}

TEST(Project, LinesThatEndEndlesslyFarAwayHaveFinitePixels) {
    for (const double far : {1e12, 1e15, 1e17, 9e17})
        for (const dvec3& end : {dvec3(far, 0, 0), dvec3(far, 0.3 * far, far), dvec3(-0.1 * far, far, -far)})
            for (const double x : {-3e-4, 0.0, 0.05}) {
                const ClippedPaths clipped = project_line({{x, 0.1, -0.3}, end, {0.0, 0.0, -far}}, camera());
                for (const vec2& px : clipped.px) EXPECT_TRUE(std::abs(px.x) < 1000 && std::abs(px.y) < 1000) << far;
                EXPECT_TRUE(std::ranges::is_sorted(clipped.arc_px));
                EXPECT_LT(clipped.samples, 10000u);
            }
}

TEST(Project, RefusesASampleStepThatIsNone) {
    for (const double step : {0.0, -1.0, 1e-30, std::numeric_limits<double>::quiet_NaN()})
        EXPECT_THROW(project_line({at_px(0, 0), at_px(99, 99)}, camera(), {.sample_step_px = step}),
                     std::invalid_argument);
}

TEST(Project, IsTheSameWithOneThreadAndMany) {
    std::vector<std::vector<dvec3>> lines;
    for (int k = 0; k < 3000; ++k) {
        lines.push_back(wave(4 + k % 9));
        for (dvec3& p : lines.back()) p.y += 0.001 * (k - 1500);
    }
    const Wires wires(lines);
    const auto run = [&](std::size_t threads) {
        const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
        return wires.project(camera());
    };
    const ClippedPaths one = run(1), many = run(8);
    const auto same = [](const auto& a, const auto& b) {
        return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size() * sizeof(a[0])) == 0;
    };
    EXPECT_GT(one.pieces.count(), 3000u);
    EXPECT_TRUE(same(one.pieces.offsets, many.pieces.offsets) && same(one.px, many.px) &&
                same(one.arc_px, many.arc_px) && same(one.sample_start, many.sample_start) &&
                same(one.position_view, many.position_view));
}
