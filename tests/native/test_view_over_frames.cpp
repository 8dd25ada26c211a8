// SPDX-License-Identifier: GPL-3.0-or-later
// Visibility over frames of lines of the view, which lie elsewhere on the surface in each frame.
#include <cmath>
#include <gtest/gtest.h>
#include <set>

#include "over_frames.h"

using namespace fovea;
using namespace fovea::draw;
using namespace fovea::drawing;
using namespace fovea::over_frames;

namespace {

Job job_of(std::vector<Placement> placements, int frames = 2, bool elided = false,
           style::Vanish vanish = style::Vanish::fade) {
    return over_frames::job_of(std::move(placements), {0, -10, 0}, style_of("smooth_contour", frames, vanish, elided));
}

/// Along x, turned about its axis, which moves its contours over it.
Placement cylinder(double roll) {
    const dmat4 lying = glm::rotate(dmat4(1.0), glm::radians(90.0), dvec3(0, 1, 0));
    return place(meshes::cylinder(64), glm::rotate(dmat4(1.0), roll, dvec3(1, 0, 0)) * lying, 1);
}

/// A cylinder whose contours lie right inside of those of another one.
Placement smaller_cylinder() {
    Placement made = cylinder(0.0);
    made.id = 3;
    made.object_to_world = made.object_to_world * scaled({0.99, 0.99, 1.0});
    return made;
}

Placement bar(double x, double bar_width) {
    const vec3 half(0.5f * float(bar_width), 0.1f, 3.0f);
    return place(meshes::box(-half, half), moved({x, -4, 0}), 2, usage_occlude);
}

/// Spheres of one object: middles and radii.
Placement spheres(const std::vector<vec4>& each, const dmat4& to_world = dmat4(1.0)) {
    meshes::Mesh mesh("spheres", {});
    const meshes::Mesh one = meshes::sphere(64);
    for (const vec4& sphere : each) {
        const int first = int(mesh.positions.size());
        for (const vec3& p : one.positions) mesh.positions.push_back(vec3(sphere) + sphere.w * p);
        for (std::size_t k = 0; k + 1 < one.polygon_offsets.size(); ++k) {
            std::vector<int> corners;
            for (int c = one.polygon_offsets[k]; c < one.polygon_offsets[k + 1]; ++c)
                corners.push_back(first + one.corner_verts[c]);
            mesh.add_polygon(corners);
        }
    }
    return place(mesh, to_world, 1);
}

/// A large sphere on the left and a small one on the right, which may be missing.
Placement two_spheres(bool both, double grown = 0.0) {
    std::vector<vec4> each{{-0.7f, 0, 0, 0.8f + float(grown)}};
    if (both) each.emplace_back(1.2f, 0, 0, 0.5f);
    return spheres(each);
}

/// The least and the largest share of the samples of the small sphere, or of the large one.
std::pair<float, float> shares_of(const Frame& frame, bool small) {
    std::pair<float, float> found{2.0f, -1.0f};
    each_sample(frame, [&](const dvec2& at, Index s) {
        if ((at.x > 0.6) != small) return;
        const float share = frame.seen.empty() ? 1.0f : frame.seen[s];
        found = {std::min(found.first, share), std::max(found.second, share)};
    });
    return found;
}

}  // namespace

TEST(ViewOverFrames, VisibilityBlurOfContoursEqualsTheAnalyticTrapezoid) {
    for (const int frames : {1, 2, 4})
        for (const double bar_width : {0.08, 0.2, 0.6}) {
            const double speed = 0.15;
            const auto frame = middle_of(
                frames, [&](int k) { return job_of({cylinder(0.03 * k), bar(speed * k, bar_width)}, frames); });
            ASSERT_FALSE(frame->seen.empty());
            double largest = 0.0;
            int count = 0;
            each_sample(*frame, [&](const dvec2& at, Index s) {
                const double share = trapezoid(at.x, bar_width, speed, frames);
                largest = std::max(largest, std::abs(frame->seen[s] - share));
                ++count;
            });
            EXPECT_GT(count, 100);
            EXPECT_LT(largest, 0.02) << frames << " frames, a bar of " << bar_width;
        }
}

TEST(ViewOverFrames, ABlinkOfOneFrameLeavesThreeQuarters) {
    const auto frame = middle_of(2, [](int k) { return job_of({cylinder(0.03 * k), bar(k == 0 ? 0.0 : 10.0, 1.0)}); });
    int inside = 0;
    each_sample(*frame, [&](const dvec2& at, Index s) {
        if (std::abs(at.x) > 0.4) return;
        EXPECT_NEAR(frame->seen[s], 0.75f, 1e-4);
        ++inside;
    });
    EXPECT_GT(inside, 50);
    EXPECT_GT(frame->drawn->size(), 0u);
    for (Index r = 0; r < frame->drawn->size(); ++r) EXPECT_EQ(frame->drawn->invisibility[r], 0);
}

TEST(ViewOverFrames, AContourThatIsThereForOneFrameAloneIsAQuarter) {
    const auto frame = middle_of(2, [](int k) { return job_of({two_spheres(k == 0, 0.003 * k)}); });
    const auto [least, most] = shares_of(*frame, true);
    EXPECT_NEAR(least, 0.25f, 1e-4);
    EXPECT_NEAR(most, 0.25f, 1e-4);
    EXPECT_GT(shares_of(*frame, false).first, 0.999f) << "that of the sphere that stays is whole";
}

TEST(ViewOverFrames, AContourThatComesIsSeenFromHalfWayOnAndOneThatGoesUntilThen) {
    for (const int direction : {-1, 1}) {
        const auto frame = middle_of(2, [&](int k) { return job_of({two_spheres(direction * k >= 0)}); });
        EXPECT_NEAR(shares_of(*frame, true).first, 2.5f / 4.0f, 1e-4) << direction;
    }
}

TEST(ViewOverFrames, OfAnObjectThatGoesTooFarFromFrameToFrameAllIsAsItIs) {
    // An ellipsoid whose contour sweeps over it.
    const auto fast = middle_of(2, [](int k) {
        const dmat4 turned = glm::rotate(dmat4(1.0), 0.7 * k, dvec3(0, 0, 1)) * scaled({1.5, 0.2, 0.8});
        return job_of({place(meshes::sphere(40), turned, 1)});
    });
    ASSERT_FALSE(fast->clipped->path.empty());
    const auto least = fast->seen.empty() ? 1.0f : *std::ranges::min_element(fast->seen);
    EXPECT_EQ(least, 1.0f);
}

TEST(ViewOverFrames, ARoundOutlineStaysWholeHoweverFarItsSurfaceTurnsInAll) {
    // Most places are of small spheres, which are found from frame to frame, and in all frames.
    std::vector<vec4> each{{0, 0, 0, 1.3f}};
    for (int i = 0; i < 12; ++i) each.emplace_back(0, 0, 0.2f * i - 1.1f, 0.15f);
    const auto frame = middle_of(8, [&](int k) {
        return job_of({spheres(each, glm::rotate(dmat4(1.0), glm::radians(4.0) * k, dvec3(0, 0, 1)))}, 8);
    });
    const auto least = frame->seen.empty() ? 1.0f : *std::ranges::min_element(frame->seen);
    EXPECT_GT(frame->clipped->samples, 100u);
    EXPECT_GT(least, 0.999f);
}

TEST(ViewOverFrames, AClosedLineThatIsHiddenAtItsSeamFadesThereAsElsewhere) {
    // The bar passes the seam, wherever it is, if it passes all of the line.
    for (double turn = 0.0; turn < 3.1; turn += 0.2) {
        const auto frame = middle_of(2, [&](int k) {
            Placement passes = bar(0.02 * k, 0.3);
            passes.object_to_world = glm::rotate(dmat4(1.0), turn, dvec3(0, 1, 0)) * passes.object_to_world;
            return job_of({place(meshes::sphere(64), dmat4(1.0), 1), passes});
        });
        double largest = 0.0;
        each_sample(*frame, [&](const dvec2& at, Index s) {
            const double across_bar = at.x * std::cos(turn) - at.y * std::sin(turn);
            largest = std::max(largest, std::abs(frame->seen[s] - trapezoid(across_bar, 0.3, 0.02, 2)));
        });
        EXPECT_LT(largest, 0.4) << turn;  // an end that moves across the seam comes on one side, and goes on the other
    }
}

TEST(ViewOverFrames, HiddenLinesAreThinnedAsInTheFrameAlone) {
    // One bar stays, and hides all the time; another one passes.
    const auto job = [](int k) {
        Placement stays = bar(0.65, 0.4);
        stays.id = 4;
        Job made = job_of({cylinder(0.0), smaller_cylinder(), bar(0.15 * k - 0.5, 0.2), stays}, 2, true);
        style::Hidden hidden;
        hidden.pen = made.style.line_sets[0].pen;
        made.style.line_sets[0].hidden.push_back(hidden);
        return made;
    };
    Frame alone(job(0));
    alone.thin();
    const auto frame = middle_of(2, job);
    ASSERT_FALSE(frame->seen.empty());
    ASSERT_EQ(frame->shown.size(), alone.shown.size());
    double least = 1.0;
    each_sample(*frame, [&](const dvec2& at, Index s) {
        if (std::abs(at.x - 0.65) > 0.15) return;
        least = std::min(least, double(alone.shown[s]));
        ASSERT_EQ(frame->shown[s], alone.shown[s]) << at.x;
    });
    EXPECT_LT(least, 0.9) << "hidden lines are thinned";
}

TEST(ViewOverFrames, WhatElisionLeavesWhereALineIsHiddenIsThatOfTheFramesWhereItIsSeen) {
    // Close to one another, one of two contours fades.
    const auto placed = [](double x) { return std::vector<Placement>{cylinder(0.0), smaller_cylinder(), bar(x, 0.3)}; };
    const auto frame = middle_of(2, [&](int k) { return job_of(placed(0.15 * k), 2, true); });
    const auto bare = middle_of(2, [&](int) { return job_of(placed(10.0), 2, true); });
    ASSERT_EQ(frame->shown.size(), bare->shown.size());
    double least = 1.0, most = 0.0, apart = 0.0;
    each_sample(*frame, [&](const dvec2& at, Index s) {
        if (std::abs(at.x) > 0.1) return;
        least = std::min(least, double(bare->shown[s]));
        most = std::max(most, double(bare->shown[s]));
        apart = std::max(apart, std::abs(double(frame->shown[s]) - bare->shown[s]));
    });
    EXPECT_LT(least, 0.1) << "one of them is left out";
    EXPECT_GT(most, 0.9);
    EXPECT_LT(apart, 0.01);
}

namespace {

/// Where visible lines end that retract, in hundredths of a unit; a bar is at bar_at(frame).
template <typename BarAt>
std::set<int> ends_of_retracting(const BarAt& bar_at) {
    const auto frame = middle_of(
        2, [&](int k) { return job_of({cylinder(0.0), bar(bar_at(k), 0.6)}, 2, false, style::Vanish::retract); });
    EXPECT_TRUE(frame->seen.empty());
    std::set<int> ends;
    for (Index r = 0; r < frame->drawn->size(); ++r) {
        if (frame->drawn->invisibility[r] != 0) continue;
        for (const double end : {frame->drawn->start_px[r], frame->drawn->end_px[r]}) {
            const Index i = frame->clipped->segment_at(frame->drawn->piece[r], end);
            const double t = frame->clipped->share_at(i, end);
            const vec2 px = glm::mix(dvec2(frame->clipped->px[i]), dvec2(frame->clipped->px[i + 1]), t);
            ends.insert(int(std::lround(units_of(px).x * 100)));
        }
    }
    return ends;
}

}  // namespace

TEST(ViewOverFrames, LinesThatRetractEndWhereTheyAreSeenForHalfOfTheTime) {
    EXPECT_EQ(ends_of_retracting([](int k) { return k == 0 ? 0.0 : 10.0; }), (std::set<int>{-100, 100}));
    EXPECT_EQ(ends_of_retracting([](int k) { return k == 0 ? 10.0 : 0.0; }), (std::set<int>{-100, -30, 30, 100}));
}
