// SPDX-License-Identifier: GPL-3.0-or-later
// Exact visibility in whole scenes: a ray for every sample is the judge; usages, instances, threads.
#include <cmath>
#include <cstring>
#include <glm/gtc/constants.hpp>
#include <glm/gtc/quaternion.hpp>
#include <gtest/gtest.h>
#include <random>
#include <tbb/global_control.h>

#include "drawing.h"

using namespace fovea;
using namespace fovea::draw;
using namespace fovea::meshes;
using namespace fovea::drawing;

namespace {

dmat4 random_motion(std::mt19937& random, double spread, double size) {
    std::uniform_real_distribution<double> unit(-1, 1);
    const auto any = [&] {
        const double z = unit(random), y = unit(random), x = unit(random);
        return dvec3(x, y, z);
    };
    const dvec3 axis = glm::normalize(any() + dvec3(1e-3));
    const double angle = 3.0 * unit(random);
    const dvec3 by = size * (0.6 + 0.4 * any()), at = spread * any();
    return moved(at) * glm::mat4_cast(glm::angleAxis(angle, axis)) * scaled(by);
}

/// Boxes, spheres and open shapes thrown into each other.
std::vector<Placement> heap(unsigned seed, int count) {
    std::mt19937 random(seed);
    const std::shared_ptr<const Surface> shapes[] = {box().surface(), sphere(6).surface(), cylinder(9).surface(),
                                                     moebius(12).surface(), bent_quad(0.7f).surface()};
    std::vector<Placement> placements;
    for (int i = 0; i < count; ++i)
        placements.push_back({shapes[i % 5], random_motion(random, 2.5, 0.7), std::uint64_t(i)});
    return placements;
}

/// One ray, without any memory: is the segment from point i of the clipped paths seen at screen fraction s?
class Judge {
   public:
    explicit Judge(const Drawing& drawing) : drawing_(drawing) {}

    bool sees(Index piece, Index i, double s) const {
        const ClippedPaths& clipped = drawing_.clipped;
        const dvec3 a(clipped.position_view[i]), b(clipped.position_view[i + 1]);
        const bool flat = drawing_.view.orthographic;
        const double wa = flat ? 1.0 : -a.z, wb = flat ? 1.0 : -b.z;
        const dvec3 point = glm::mix(a, b, s * wa / (wb + s * (wa - wb)));
        const Index placement = drawing_.paths.placement[clipped.path[piece]];
        const Ignore own = drawing_.tracer.ignore_at(placement, drawing_.paths.place[clipped.source[i]]);
        return !drawing_.tracer.occluder(vec3(point), own);
    }

    /// True where the judge says the same at s and a sixteenth of a pixel (and a little) before and after.
    bool certain(Index piece, Index i, double s, double length_px) const {
        const double off = 1.2 * exact_tolerance_px / length_px;
        const bool here = sees(piece, i, s);
        return here == sees(piece, i, std::max(0.0, s - off)) && here == sees(piece, i, std::min(1.0, s + off));
    }

   private:
    const Drawing& drawing_;
};

struct Agreement {
    std::size_t samples = 0, visible = 0, uncertain = 0, wrong = 0;
};

Agreement agreement(const Drawing& drawing) {
    Agreement result;
    const Judge judge(drawing);
    const ClippedPaths& clipped = drawing.clipped;
    std::size_t run = 0;
    for (Index q = 0; q < clipped.pieces.count(); ++q) {
        while (run < drawing.runs.piece.size() && drawing.runs.piece[run] < q) ++run;
        for (Index i = clipped.pieces.begin(q); i + 1 < clipped.pieces.end(q); ++i) {
            const double length = clipped.arc_px[i + 1] - clipped.arc_px[i];
            for (Index j = 0; j < clipped.sample_count[i]; ++j) {
                const double s = (j + 0.5) / clipped.sample_count[i], arc = clipped.arc_px[i] + s * length;
                bool visible = false;
                for (std::size_t r = run; r < drawing.runs.piece.size() && drawing.runs.piece[r] == q; ++r)
                    visible = visible || (drawing.runs.start_px[r] <= arc && arc <= drawing.runs.end_px[r]);
                ++result.samples;
                result.visible += visible;
                if (visible == judge.sees(q, i, s)) continue;
                ++(judge.certain(q, i, s, length) ? result.wrong : result.uncertain);
            }
        }
    }
    return result;
}

}  // namespace

TEST(ExactScene, AgreesWithARayForEverySample) {
    const View from_outside = perspective({5, -6, 4}, {0, 0, 0}, 50, 1600, 1200);
    const View views[] = {from_outside, perspective({0.4, 0.2, 0.1}, {3, 2, 1}, 18, 1600, 1200),
                          orthographic({-4, -5, 6}, {0, 0, 0}, 6, 1600, 1200), with_near(from_outside, 8.0)};
    for (unsigned seed = 1; seed <= 5; ++seed)
        for (const View& view : views) {
            const Drawing drawing(heap(seed, 60), view, {all_edges(), line_set({"contour", "border"})});
            const Agreement found = agreement(drawing);
            EXPECT_GT(found.samples, 3000u);
            EXPECT_GT(found.visible, found.samples / 20);
            EXPECT_LT(found.visible, found.samples);
            EXPECT_EQ(found.wrong, 0u) << "of " << found.samples << ", seed " << seed;
            EXPECT_LT(found.uncertain, found.samples / 200);
        }
}

TEST(ExactScene, ALineOfManyPointsIsWholeWhereNothingHidesIt) {
    constexpr int corners = 1700;
    std::vector<vec3> circle;
    meshes::Polygons polygon(1);
    for (int i = 0; i < corners; ++i) {
        const float angle = 2.0f * glm::pi<float>() * float(i) / corners;
        circle.emplace_back(std::cos(angle), std::sin(angle), 0.0f);
        polygon[0].push_back(i);
    }
    const std::vector<Placement> placed{place(meshes::of_polygons("disc", circle, polygon), moved({0, 0, 0}), 1)};
    const Drawing drawing(placed, orthographic({0, 0, 5}, {0, 0, 0}, 3, 800, 800), {line_set({"border"})});
    const ClippedPaths& clipped = drawing.clipped;
    ASSERT_EQ(clipped.pieces.count(), 1u);
    EXPECT_EQ(clipped.px.size(), corners + 1u);
    ASSERT_EQ(drawing.runs.size(), 1u);
    EXPECT_EQ(drawing.runs.start_px[0], clipped.first_arc(0));
    EXPECT_EQ(drawing.runs.end_px[0], clipped.last_arc(0));
}

TEST(ExactScene, RunsEndWhereVisibilityChanges) {
    const Drawing drawing(heap(11, 80), perspective({5, -6, 4}, {0, 0, 0}, 50, 1600, 1200), {all_edges()});
    const Judge judge(drawing);
    const ClippedPaths& clipped = drawing.clipped;
    const double near_px = 1.2 * exact_tolerance_px;
    std::size_t ends = 0, off = 0;
    for (std::size_t r = 0; r < drawing.runs.piece.size(); ++r) {
        const Index q = drawing.runs.piece[r];
        for (Index i = clipped.pieces.begin(q); i + 1 < clipped.pieces.end(q); ++i) {
            const double from = clipped.arc_px[i], length = clipped.arc_px[i + 1] - from;
            for (const double end : {drawing.runs.start_px[r], drawing.runs.end_px[r]}) {
                if (end - from < 0.5 || from + length - end < 0.5) continue;  // not inside this segment
                const double inwards = end == drawing.runs.start_px[r] ? near_px : -near_px;
                ++ends;
                off += !judge.sees(q, i, (end + inwards - from) / length) ||
                       judge.sees(q, i, (end - inwards - from) / length);
            }
        }
    }
    EXPECT_GT(ends, 200u);
    EXPECT_LE(off, ends / 100) << "but for two changes within a sixteenth of a pixel";
}

TEST(ExactScene, RunsAreSortedDisjointAndInsideTheirPieces) {
    const Drawing drawing(heap(3, 40), perspective({5, -6, 4}, {0, 0, 0}), {all_edges()});
    const Runs& runs = drawing.runs;
    ASSERT_GT(runs.piece.size(), 100u);
    for (std::size_t r = 0; r < runs.piece.size(); ++r) {
        const Index q = runs.piece[r];
        EXPECT_LT(runs.start_px[r], runs.end_px[r]);
        EXPECT_GE(runs.start_px[r], drawing.clipped.arc_px[drawing.clipped.pieces.begin(q)]);
        EXPECT_LE(runs.end_px[r], drawing.clipped.arc_px[drawing.clipped.pieces.end(q) - 1] + 1e-9);
        if (r > 0) {
            EXPECT_TRUE(runs.piece[r - 1] < q || (runs.piece[r - 1] == q && runs.end_px[r - 1] < runs.start_px[r]));
        }
    }
}

TEST(ExactScene, WhatHidesIsUpToUsageAndMaterial) {
    const View view = perspective({0, -8, 0}, {0, 0, 0});
    const auto visible = [&](const Mesh& before, int usage) {
        const Drawing drawing({place(tetrahedron()), place(before, moved({0, -3, 0}) * scaled({2, 0.1, 2}), 2, usage)},
                              view, {all_edges()});
        return drawing.visible_px(0);
    };
    EXPECT_EQ(visible(box(), usage_draw | usage_occlude), 0.0);
    EXPECT_EQ(visible(box(), usage_occlude), 0.0);
    EXPECT_EQ(visible(box(), usage_holdout), 0.0);
    EXPECT_GT(visible(box(), usage_draw), 100.0);
    EXPECT_GT(visible(box(), 0), 100.0);
    Mesh glass = box();
    glass.occluding.assign(6, 0);
    EXPECT_GT(visible(glass, usage_draw | usage_occlude), 100.0);
    glass.occluding[3] = 1;  // the face away from the viewer
    EXPECT_EQ(visible(glass, usage_draw | usage_occlude), 0.0);
}

TEST(ExactScene, InstancesHideLikeOneMesh) {
    // The same boxes as placements of one surface, and joined into one mesh.
    const Mesh one = box();
    const auto surface = one.surface();
    Mesh joined("joined", {});
    std::vector<Placement> placements;
    for (int i = 0; i < 25; ++i) {
        const dvec3 at(i % 5 - 2.0, i / 5 - 2.0, 0.1 * (i * 7 % 5));
        placements.push_back({surface, moved(at) * scaled(dvec3(0.3)), std::uint64_t(i)});
        const int base = static_cast<int>(joined.positions.size());
        for (const vec3& p : one.positions) joined.positions.push_back(0.3f * p + vec3(at));
        for (int f = 0; f < 6; ++f)
            joined.add_polygon({base + one.corner_verts[4 * f], base + one.corner_verts[4 * f + 1],
                                base + one.corner_verts[4 * f + 2], base + one.corner_verts[4 * f + 3]});
    }
    const View view = perspective({4, -5, 3}, {0, 0, 0});
    const Drawing many(placements, view, {all_edges()}), single({place(joined)}, view, {all_edges()});
    double sum = 0.0;
    for (Index i = 0; i < 25; ++i) sum += many.visible_px(i);
    EXPECT_NEAR(sum, single.visible_px(0), 1e-3 * sum);
    EXPECT_LT(sum, 0.8 * single.total_px(0));
}

TEST(ExactScene, NothingSeenGivesNoRuns) {
    const Drawing hidden({place(tetrahedron()), place(box(), scaled(dvec3(2)), 2, usage_occlude)},
                         perspective({4, -5, 3}, {0, 0, 0}), {all_edges()});
    EXPECT_GT(hidden.clipped.samples, 0u);
    EXPECT_TRUE(hidden.runs.piece.empty());
    const Drawing empty({}, perspective({4, -5, 3}, {0, 0, 0}), {all_edges()});
    EXPECT_TRUE(empty.runs.piece.empty());
}

TEST(ExactScene, IsTheSameWithOneThreadAndMany) {
    const auto run = [&](std::size_t threads) {
        const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
        std::vector<Placement> placements = heap(21, 120);
        placements.push_back(place(sphere(200), moved({0, 2, 0}), 99));
        return Drawing(placements, perspective({5, -6, 4}, {0, 0, 0}, 50, 1280, 960),
                       {all_edges(), line_set({"contour"})})
            .runs;
    };
    const Runs one = run(1);
    ASSERT_GT(one.piece.size(), 1000u);
    for (const std::size_t threads : {2u, 8u, 1u}) {
        const Runs many = run(threads);
        ASSERT_EQ(one.piece.size(), many.piece.size());
        EXPECT_EQ(std::memcmp(one.piece.data(), many.piece.data(), one.piece.size() * sizeof(Index)), 0);
        EXPECT_EQ(std::memcmp(one.start_px.data(), many.start_px.data(), one.piece.size() * sizeof(double)), 0);
        EXPECT_EQ(std::memcmp(one.end_px.data(), many.end_px.data(), one.piece.size() * sizeof(double)), 0);
    }
}
