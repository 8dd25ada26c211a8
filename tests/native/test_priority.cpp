// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <gtest/gtest.h>
#include <limits>
#include <tbb/global_control.h>

#include <fovea/elision/priority.h>

#include "wires.h"

using namespace fovea;
using namespace fovea::draw;

namespace {

style::Elision only(double style::Elision::* weight) {
    style::Elision weights;
    weights.length = weights.kind = weights.strength = weights.depth = weights.object = weights.painted = 0.0;
    weights.*weight = 1.0;
    return weights;
}
const style::Elision only_length = only(&style::Elision::length), only_kind = only(&style::Elision::kind),
                     only_strength = only(&style::Elision::strength), only_depth = only(&style::Elision::depth),
                     only_object = only(&style::Elision::object);

/// Three lines, longer and longer, farther and farther away.
wires::Wires lines(double scale = 1.0) {
    std::vector<std::vector<dvec3>> all;
    for (const double k : {1.0, 2.0, 4.0})
        all.push_back({dvec3(-k, 0.1 * k, -5.0 * k) * scale, dvec3(k, 0, -5.0 * k) * scale});
    return wires::Wires(all);
}

Array<float> priorities(const wires::Wires& w, const style::Elision& weights = {}, In<float> object = {},
                        In<float> painted = {}) {
    return path_priorities(w.paths, w.scene, wires::camera(), weights, object, painted);
}

}  // namespace

TEST(Priority, LongerIsHigherAndNearerIsHigher) {
    const Array<float> by_length = priorities(lines(), only_length), by_depth = priorities(lines(), only_depth);
    for (int k = 0; k < 2; ++k) {
        EXPECT_LT(by_length[k], by_length[k + 1]);
        EXPECT_GT(by_depth[k], by_depth[k + 1]);
    }
    const wires::Wires some = lines();
    const double radius = scene_radius(some.scene), length = glm::distance(dvec3(-4, 0.4, 0), dvec3(4, 0, 0));
    EXPECT_NEAR(by_length[2], length / (length + radius / 10.0), 1e-5);
    EXPECT_NEAR(by_depth[1], radius / (radius + 10.0), 1e-5);
}

TEST(Priority, TheSameForASceneOfAnySize) {
    const Array<float> plain = priorities(lines());
    for (const double scale : {0.001, 1000.0}) {
        const Array<float> scaled = priorities(lines(scale));
        for (std::size_t p = 0; p < plain.size(); ++p) EXPECT_NEAR(plain[p], scaled[p], 1e-5) << scale;
    }
    // Also where the object is scaled, not its mesh.
    wires::Wires placed = lines();
    placed.scene.placements[0].object_to_world = drawing::scaled(dvec3(1000.0));
    const Array<float> scaled = priorities(placed);
    for (std::size_t p = 0; p < plain.size(); ++p) EXPECT_NEAR(plain[p], scaled[p], 1e-5);
}

TEST(Priority, EveryTermLiesBetweenNothingAndAll) {
    const wires::Wires endless({{{0, 0, -1}, {1e30, 0, -1}}, {{0, 0, -1}, {1e-30, 0, -1}}, {{0, 0, 1e9}, {0, 1, 1e9}}});
    for (const style::Elision& weights :
         {only_length, only_kind, only_strength, only_depth, only_object, style::Elision()})
        for (const float value : priorities(endless, weights)) {
            EXPECT_GE(value, 0.0f);
            EXPECT_LE(value, 1.0f);
        }
}

TEST(Priority, OutlinesBeforeCreasesBeforeLinesOnSmoothSurfaces) {
    const auto of = [](const char* name) { return definition_called(name).importance; };
    // What is behind an outline changes at once: it makes one of the other, which shall not displace lines beside it.
    EXPECT_EQ(of("silhouette"), of("contour"));
    EXPECT_EQ(of("smooth_silhouette"), of("smooth_contour"));
    EXPECT_EQ(of("silhouette"), of("smooth_silhouette"));
    EXPECT_GT(of("contour"), of("border"));
    EXPECT_GT(of("border"), of("crease"));
    EXPECT_GT(of("crease"), of("intersection"));
    EXPECT_GT(of("intersection"), of("suggestive_contour"));
    EXPECT_GT(of("suggestive_contour"), of("isophote"));
}

TEST(Priority, APathOfSeveralKindsHasTheirMeanByLength) {
    wires::Wires w({{{0, 0, -5}, {1, 0, -5}, {4, 0, -5}}});
    const Kinds crease = drawing::bit_of("crease"), silhouette = drawing::bit_of("silhouette");
    w.paths.kinds[0] = crease | silhouette;
    w.paths.kinds[1] = crease;
    const auto importance = [](const char* name) { return definition_called(name).importance; };
    EXPECT_NEAR(priorities(w, only_kind)[0], (importance("silhouette") + 3.0 * importance("crease")) / 4.0, 1e-6);
    w.paths.strength[0] = 0.0f;
    EXPECT_NEAR(priorities(w, only_strength)[0], (0.5 + 3.0) / 4.0, 1e-6);
    w.paths.strength[2] = std::numeric_limits<float>::quiet_NaN();
    EXPECT_NEAR(priorities(w, only_strength)[0], (0.5 + 1.5) / 4.0, 1e-6);
}

TEST(Priority, WhatTheCallerAndTheArtistSay) {
    const wires::Wires w = lines();
    const std::vector<float> object{0.9f}, per_path{0.1f, 0.5f, 2.0f}, per_point{0.0f, 0.5f, 1.0f, 1.0f, 0.0f, 0.0f};
    EXPECT_EQ(priorities(w, only_object), Array<float>(3, 0.5f));
    EXPECT_EQ(priorities(w, only_object, object), Array<float>(3, 0.9f));
    const style::Elision painted = only(&style::Elision::painted);
    EXPECT_EQ(priorities(w, painted, {}, per_path), (Array<float>{0.1f, 0.5f, 1.0f}));
    EXPECT_EQ(priorities(w, painted, {}, per_point), (Array<float>{0.25f, 1.0f, 0.0f}));
    EXPECT_THROW(priorities(w, painted), std::invalid_argument);
    EXPECT_THROW(priorities(w, {}, per_path), std::invalid_argument);
    EXPECT_THROW(priorities(w, {}, {}, object), std::invalid_argument);
    style::Elision below;
    below.length = -1.0;
    EXPECT_THROW(priorities(w, below), std::invalid_argument);
}

TEST(Priority, OfNothing) {
    EXPECT_TRUE(priorities(wires::Wires({})).empty());
    EXPECT_EQ(scene_radius(Scene()), 0.0);
    EXPECT_TRUE(rank_runs(ClippedPaths(), Runs(), {}, {}).empty());
}

TEST(Priority, TheSameForAnyNumberOfThreads) {
    std::vector<std::vector<dvec3>> many;
    for (int k = 0; k < 3000; ++k) many.push_back({{0.01 * k, 0, -5}, {0.01 * k, 1.0 + 0.001 * k, -5}});
    const wires::Wires w(many);
    const Array<float> all = priorities(w);
    tbb::global_control one(tbb::global_control::max_allowed_parallelism, 1);
    EXPECT_EQ(all, priorities(w));
}

TEST(Rank, VisibleBeforeHiddenThenPriorityThenId) {
    ClippedPaths clipped;
    clipped.path = {0, 1, 2, 3, 1};
    Runs runs;
    runs.push(0, 0, 1);
    runs.push(1, 0, 1, 2);
    runs.push(1, 1, 2);
    runs.push(2, 0, 1);
    runs.push(3, 0, 1, 1);
    runs.push(4, 0, 1);
    const float nan = std::numeric_limits<float>::quiet_NaN();
    const std::vector<float> priority{0.5f, 0.9f, 0.5f, nan};
    const std::vector<std::uint64_t> id{7, 1, 3, 2};
    EXPECT_EQ(rank_runs(clipped, runs, priority, id), (Array<Index>{3, 2, 5, 4, 1, 5}));
    EXPECT_THROW(rank_runs(clipped, runs, {}, {}), std::invalid_argument);
}

TEST(Rank, DoesNotDependOnTheOrderOfPaths) {
    const std::vector<float> priority{0.3f, 0.3f, 0.8f, 0.1f, 0.3f};
    const std::vector<std::uint64_t> id{50, 10, 30, 20, 40};
    const auto ranked = [&](const std::vector<Index>& order) {
        ClippedPaths clipped;
        Runs runs;
        std::vector<float> p;
        std::vector<std::uint64_t> names;
        for (Index q = 0; q < order.size(); ++q) {
            clipped.path.push_back(q);
            runs.push(q, 0, 1);
            p.push_back(priority[order[q]]);
            names.push_back(id[order[q]]);
        }
        const Array<Index> ranks = rank_runs(clipped, runs, p, names);
        std::vector<Index> of(order.size());
        for (Index q = 0; q < order.size(); ++q) of[order[q]] = ranks[q];
        return of;
    };
    EXPECT_EQ(ranked({0, 1, 2, 3, 4}), (std::vector<Index>{2, 4, 5, 1, 3}));
    EXPECT_EQ(ranked({4, 2, 0, 1, 3}), ranked({0, 1, 2, 3, 4}));
}
