// SPDX-License-Identifier: GPL-3.0-or-later
// Quantitative invisibility in whole scenes: every triangle is the judge; scale, cameras, threads.
#include <cstring>
#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <fovea/visibility/segment.h>

#include "counted.h"

using namespace fovea;
using namespace fovea::draw;
using namespace fovea::meshes;
using namespace fovea::drawing;
using namespace fovea::wires;

namespace {

/// Boxes, spheres and sheets in a heap, with lines of all of them.
std::vector<Placement> heap(double unit = 1.0) {
    const std::shared_ptr<const Surface> shapes[] = {box().surface(), sphere(9).surface(), cylinder(9).surface(),
                                                     moebius(12).surface()};
    std::vector<Placement> placements;
    for (int i = 0; i < 60; ++i) {
        const dvec3 at(std::fmod(i * 0.618, 1.0) * 6 - 3, std::fmod(i * 0.414, 1.0) * 6 - 3,
                       std::fmod(i * 0.732, 1.0) * 4 - 2);
        const dmat4 turn = glm::rotate(dmat4(1.0), 1.3 * i, glm::normalize(dvec3(1, 0.3 * i, 0.7)));
        placements.push_back({shapes[i % 4],
                              scaled(dvec3(unit)) * moved(at) * turn * scaled(dvec3(0.3 + 0.01 * (i % 37))),
                              std::uint64_t(i + 1)});
    }
    return placements;
}

View heap_view(double unit = 1.0, double away = 1.0) {
    View view = perspective(unit * away * dvec3(7, -9, 5), {0, 0, 0}, 50 * away, 1280, 960);
    view.far_clip *= unit * away;
    return with_near(view, view.near_clip * unit);
}

/// Length of the parts of pieces where two results differ, in pixels.
double different_px(const Runs& a, const Runs& b) {
    double sum = 0.0;
    std::size_t i = 0, j = 0;
    while (i < a.size() && j < b.size()) {
        if (a.piece[i] != b.piece[j]) {
            ++(a.piece[i] < b.piece[j] ? i : j);
            continue;
        }
        const double from = std::max(a.start_px[i], b.start_px[j]), to = std::min(a.end_px[i], b.end_px[j]);
        if (a.invisibility[i] != b.invisibility[j]) sum += std::max(0.0, to - from);
        ++(a.end_px[i] < b.end_px[j] ? i : j);
    }
    return sum;
}

}  // namespace

TEST(InvisibilityScene, ScenesOfAnySizeGiveTheSameRuns) {
    const auto of = [](double unit) {
        const Drawing drawing(heap(unit), heap_view(unit), {all_edges()});
        return Counted(drawing.scene, drawing.paths, drawing.view, 12).runs;
    };
    const Runs one = of(1.0);
    ASSERT_GT(one.size(), 1000u);
    EXPECT_GT(*std::max_element(one.invisibility.begin(), one.invisibility.end()), 4);
    for (const double unit : {0.001, 1000.0}) {
        const Runs other = of(unit);
        EXPECT_LT(different_px(one, other), exact_tolerance_px * one.size() / 100) << unit;
        EXPECT_NEAR(other.size(), one.size(), one.size() / 100);
    }
}

TEST(InvisibilityScene, AFarCameraTendsToAnOrthographicOne) {
    const dvec3 way = glm::normalize(dvec3(7, -9, 5));
    View far = perspective(4000.0 * way, {0, 0, 0}, 18.0 * 4000.0 / 5.0, 1280, 960);
    far.far_clip = 9000.0;
    far = with_near(far, 3950.0);
    View flat = orthographic(4000.0 * way, {0, 0, 0}, 10, 1280, 960);  // as far: the margin of rays is a share of it
    flat.far_clip = 9000.0;
    flat = with_near(flat, 3950.0);
    std::map<int, double> lengths[2];
    for (const View& view : {far, flat}) {
        const Drawing drawing(heap(), view, {all_edges()});
        lengths[view.orthographic] = Counted(drawing.scene, drawing.paths, view, 3).lengths();
    }
    ASSERT_EQ(lengths[1].size(), 4u);
    for (const auto& [number, length] : lengths[1]) EXPECT_NEAR(lengths[0][number], length, 0.01 * length) << number;
}

TEST(InvisibilityScene, IsTheSameWithOneThreadAndMany) {
    const Drawing drawing(heap(), heap_view(), {all_edges()});
    const auto run = [&](std::size_t threads) {
        const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
        return Counted(drawing.scene, drawing.paths, drawing.view, 6).runs;
    };
    const Runs one = run(1), many = run(8);
    ASSERT_EQ(one.size(), many.size());
    EXPECT_EQ(one.piece, many.piece);
    EXPECT_EQ(one.invisibility, many.invisibility);
    EXPECT_EQ(std::memcmp(one.start_px.data(), many.start_px.data(), one.size() * sizeof(double)), 0);
    EXPECT_EQ(std::memcmp(one.end_px.data(), many.end_px.data(), one.size() * sizeof(double)), 0);
}

namespace {

/// How many surfaces hide a point, by every triangle of the scene, in double precision; solid: boxes and spheres.
int by_every_triangle(const Drawing& drawing, const dvec3& point, const Ignore& ignore) {
    int count = 0;
    for (Index p = 0; p < drawing.scene.placements.size(); ++p) {
        const Placement& placement = drawing.scene.placements[p];
        const Surface& surface = *placement.surface;
        const dmat4 to_view = drawing.view.world_to_view * placement.object_to_world;
        int sides[2] = {0, 0};
        for (Index t = 0; t < surface.occluding_triangles; ++t) {
            if (ignore.holds(p, surface, t)) continue;
            dvec3 c[3];
            for (int k = 0; k < 3; ++k)
                c[k] = dvec3(to_view * dvec4(dvec3(surface.positions[surface.triangles[t][k]]), 1.0));
            const double u = glm::dot(point, glm::cross(c[0], c[1])), v = glm::dot(point, glm::cross(c[1], c[2]));
            const double w = glm::dot(point, glm::cross(c[2], c[0])), sum = u + v + w;
            if ((u < 0) != (sum < 0) || (v < 0) != (sum < 0) || (w < 0) != (sum < 0)) continue;
            const double share = glm::determinant(dmat3(c[0], c[1], c[2])) / sum;
            if (share > 0.0 && share < 1.0 - ray_margin) ++sides[sum > 0];
        }
        const bool solid = surface.name() == "box" || surface.name() == "sphere";
        count += solid ? std::max(sides[0], sides[1]) : sides[0] + sides[1];
    }
    return count;
}

}  // namespace

TEST(InvisibilityScene, AgreesWithEveryTriangleOneByOne) {
    const Drawing drawing(heap(), heap_view(), {all_edges()});
    const Counted counted(drawing.scene, drawing.paths, drawing.view, 12);
    int asked = 0, wrong = 0;
    for (std::size_t r = 0; r < counted.runs.size(); ++r) {
        if (counted.runs.end_px[r] - counted.runs.start_px[r] < 4.0) continue;
        const Index q = counted.runs.piece[r];
        const double middle = 0.5 * (counted.runs.start_px[r] + counted.runs.end_px[r]);
        Index i = first_of(counted.clipped, q);
        while (counted.clipped.arc_px[i + 1] < middle) ++i;
        const visibility::Segment segment = segment_at(counted.clipped, drawing.paths, drawing.tracer, q, i);
        const double s =
            (middle - counted.clipped.arc_px[i]) / (counted.clipped.arc_px[i + 1] - counted.clipped.arc_px[i]);
        ++asked;
        wrong += by_every_triangle(drawing, segment.at(s), segment.ignore) != counted.runs.invisibility[r];
    }
    EXPECT_GT(asked, 1000);
    EXPECT_LE(wrong, asked / 100) << "but for what is narrower than a sample";
}
