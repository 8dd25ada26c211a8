// SPDX-License-Identifier: GPL-3.0-or-later
// Intersections of surfaces in any position: closed, the same for every motion, order and number of threads, kept.
#include <cstring>
#include <gtest/gtest.h>
#include <limits>
#include <numeric>
#include <random>
#include <tbb/global_control.h>

#include "intersections.h"
#include "rules.h"

using namespace fovea;
using namespace fovea::draw;
using namespace fovea::intersections;

TEST(Intersection, BrokenAndThinTrianglesLeaveNoGaps) {
    // A sphere split into slivers: every quad has a vertex next to the middle of a side, or on it exactly.
    for (const float off : {0.0f, 1e-7f, 1e-4f}) {
        Mesh mesh("slivers", {{0, 0, 1.2f}, {0, 0, -1.2f}});
        const int n = 12;
        for (int i = 0; i < n; ++i) {
            const double a = 2 * std::numbers::pi * i / n;
            mesh.positions.push_back(vec3(dvec3(std::cos(a), std::sin(a), 0)));
        }
        for (int i = 0; i < n; ++i) {
            const int a = 2 + i, b = 2 + (i + 1) % n, m = static_cast<int>(mesh.positions.size());
            mesh.positions.push_back(0.5f * (mesh.positions[a] + mesh.positions[0]) + vec3(0, 0, off));
            mesh.add_polygon({a, b, m});
            mesh.add_polygon({m, b, 0});
            mesh.add_polygon({a, m, 0});  // a sliver
            mesh.add_polygon({b, a, 1});
        }
        const Found found({put(mesh, dmat4(1.0), 1), put(grid(5, 3), turned(0.2, {1, 2, 0}) * moved({0, 0, 0.3}), 2)});
        EXPECT_GE(found.count, 1u) << off;
        EXPECT_GE(found.length, 4.0) << off;
        if (off > 0.0f) {
            EXPECT_EQ(found.count, 1u) << off;
            EXPECT_EQ(found.closed, 1u) << off;
        }
    }
    Mesh broken = sphere(16);
    const Found whole({put(broken, dmat4(1.0), 1), put(grid(1, 3), moved({0, 0, 0.1}), 2)});
    broken.positions[20] = vec3(std::numeric_limits<float>::quiet_NaN());
    broken.positions[60] = vec3(std::numeric_limits<float>::infinity());
    const Found rest({put(broken, dmat4(1.0), 1), put(grid(1, 3), moved({0, 0, 0.1}), 2)});
    EXPECT_EQ(whole.closed, 1u);
    EXPECT_GT(rest.length, 0.7 * whole.length);
    EXPECT_LE(rest.length, whole.length);
    for (const dvec3& p : rest.at) EXPECT_NEAR(p.z, 0.1, 1e-6);
}

TEST(Intersection, IsClosedWhereSurfacesAre) {
    std::mt19937 random(5);
    std::uniform_real_distribution<double> unit(-1, 1);
    const auto any = [&] { return dvec3{unit(random), unit(random), unit(random)}; };
    const Mesh shapes[] = {box(), sphere(9), tetrahedron(), torus(1, 0.4, 16, 8)};
    std::vector<Placement> placements;
    for (std::uint64_t i = 0; i < 60; ++i) {
        const double angle = 3.0 * unit(random);
        const dvec3 axis = any() + dvec3(1e-3), at = 1.5 * any(), by = 0.4 + 0.3 * any();
        placements.push_back(put(shapes[i % 4], moved(at) * turned(angle, axis) * scaled(by), i));
    }
    const Found found(placements);
    EXPECT_GT(found.count, 100u);
    EXPECT_EQ(found.closed, found.count);
}

TEST(Intersection, IsClosedWhereVerticesLieInEachOthersFaces) {
    // Equators, poles and meridians lie in the faces of boxes, and edges cross in one point.
    std::vector<Placement> placements;
    std::uint64_t id = 0;
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j) {
            placements.push_back(put(sphere(8), moved({2.0 * i, 2.0 * j, 0}), ++id));
            placements.push_back(put(box(), moved({2.0 * i + 1, 2.0 * j, 0}) * scaled(dvec3(0.5)), ++id));
        }
    placements.push_back(put(grid(6, 6), dmat4(1.0), ++id));
    const Found found(placements, {1, 0});
    EXPECT_GT(found.count, 15u);
    EXPECT_EQ(found.closed, found.count);
}

TEST(Intersection, DoesNotDependOnMotionOrOrder) {
    const Mesh ball = sphere(20), brick = box();
    const dmat4 in_ball = moved({0.6, 0.5, 0.3}) * turned(0.5, {1, 1, 0});
    const Found found({put(ball, dmat4(1.0), 1), put(brick, in_ball, 2)});
    EXPECT_EQ(found.closed, 1u);
    for (const dmat4& motion : {moved({3, -2, 1}) * turned(1.3, {1, 2, 3}), scaled(dvec3(2)), scaled({-1, 1, 1})}) {
        const Found again({put(ball, motion, 1), put(brick, motion * in_ball, 2)});
        EXPECT_EQ(again.closed, found.count);
        EXPECT_EQ(again.points, found.points);
        EXPECT_NEAR(again.length, found.length * std::abs(motion[0][0] == 2.0 ? 2.0 : 1.0), 1e-4);
    }
    const auto sorted = [](Found f) {
        std::sort(f.at.begin(), f.at.end(), [](const dvec3& a, const dvec3& b) {
            return a.x != b.x ? a.x < b.x : a.y != b.y ? a.y < b.y : a.z < b.z;
        });
        f.at.erase(std::unique(f.at.begin(), f.at.end(),
                               [](const dvec3& a, const dvec3& b) { return glm::distance(a, b) < 1e-9; }),
                   f.at.end());
        return f.at;
    };
    // Faces in another order and turned around.
    Mesh shuffled(ball.name, ball.positions);
    for (std::size_t f = ball.polygon_offsets.size() - 1; f-- > 0;) {
        std::vector<int> verts(ball.corner_verts.begin() + ball.polygon_offsets[f],
                               ball.corner_verts.begin() + ball.polygon_offsets[f + 1]);
        if (f % 3 == 0 && verts.size() == 3) std::reverse(verts.begin(), verts.end());
        shuffled.add_polygon(verts);
    }
    const auto before = sorted(found), after = sorted(Found({put(shuffled, dmat4(1.0), 1), put(brick, in_ball, 2)}));
    ASSERT_EQ(before.size(), after.size());
    for (std::size_t i = 0; i < before.size(); ++i) EXPECT_NEAR(glm::distance(before[i], after[i]), 0.0, 1e-6);
}

TEST(Intersection, IsTheSameWithOneThreadAndMany) {
    const auto run = [&](std::size_t threads) {
        const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
        std::vector<Placement> placements;
        for (std::uint64_t i = 0; i < 12; ++i)
            placements.push_back(put(i % 2 ? sphere(60) : torus(1, 0.4, 50, 30),
                                     moved({0.3 * double(i % 4), 0.4 * double(i / 4), 0.1}), i));
        Drawing drawing(placements, somewhere, {line_set({"intersection"})});
        return std::move(drawing.paths);
    };
    const Paths one = run(1);
    ASSERT_GT(one.count(), 20u);
    for (const std::size_t threads : {2u, 8u}) {
        const Paths many = run(threads);
        ASSERT_EQ(one.points_obj.size(), many.points_obj.size());
        EXPECT_EQ(std::memcmp(one.points_obj.data(), many.points_obj.data(), one.points_obj.size() * sizeof(vec3)), 0);
        EXPECT_EQ(one.id, many.id);
        EXPECT_EQ(one.other_facet, many.other_facet);
    }
    EXPECT_EQ(std::set<std::uint64_t>(one.id.begin(), one.id.end()).size(), one.count()) << "no two ids are the same";
}

TEST(Intersection, IsFoundOnceForAllViewsAndForWhatMovesTogether) {
    const SceneRule& rule = rule_of<SceneRule>("intersection");
    const auto ball = sphere(20).surface(), brick = box().surface();
    const auto find = [&](dmat4 first, dmat4 second) {
        const Scene scene({{ball, first, 1}, {brick, second, 2}});
        const std::vector<Index> drawn = {0, 1};
        const auto found = rule.find(scene, drawn, {1, 0}, Cancel());
        return found.size() == 1 ? found[0].curves : nullptr;
    };
    const dmat4 motion = moved({3, -2, 1}) * turned(1.3, {1, 2, 3}), apart = moved({0.5, 0.5, 0.5});
    const auto once = find(dmat4(1.0), apart);
    ASSERT_NE(once, nullptr);
    EXPECT_FALSE(once->pieces.empty());
    EXPECT_EQ(find(dmat4(1.0), apart), once);
    EXPECT_EQ(find(motion, motion * apart), once);
    EXPECT_NE(find(dmat4(1.0), moved({0.5, 0.5, 0.6})), once);
    // Pairs of instances, too.
    const Scene instances(
        {{ball, dmat4(1.0), 1}, {brick, apart, 2}, {ball, moved({9, 0, 0}), 3}, {brick, moved({9, 0, 0}) * apart, 4}});
    const std::vector<Index> all = {0, 1, 2, 3};
    const auto pairs = rule.find(instances, all, {1, 0}, Cancel());
    ASSERT_EQ(pairs.size(), 2u);
    EXPECT_EQ(pairs[0].curves, once);
    EXPECT_EQ(pairs[1].curves, once);
    std::vector<vec3> positions(brick->positions.begin(), brick->positions.end() - 1);
    for (vec3& p : positions) p *= 1.5f;
    brick->set_positions(positions);
    const auto grown = find(dmat4(1.0), apart);
    EXPECT_NE(grown, once);
    EXPECT_NE(grown->pieces.size(), once->pieces.size());
}

TEST(Intersection, OfHeapedInstancesIsWithOtherObjectsOnly) {
    const SceneRule& rule = rule_of<SceneRule>("intersection");
    const auto leaf = box().surface(), ground = grid(3, 9).surface();
    const auto pairs = [&](Index leaves) {
        std::vector<Placement> placements = {{ground, dmat4(1.0), 100}};
        for (Index i = 0; i < leaves; ++i) placements.push_back({leaf, turned(0.1 * i, {1, 2, 3}), i + 1});
        std::vector<Index> drawn(placements.size());
        std::iota(drawn.begin(), drawn.end(), Index(0));
        std::size_t with_ground = 0, with_leaves = 0;
        for (const SceneCurves& part : rule.find(Scene(placements), drawn, {1, 0}, Cancel())) {
            if (part.curves->pieces.empty()) continue;
            ++(part.placement == 0 || part.other == 0 ? with_ground : with_leaves);
        }
        return std::pair(with_ground, with_leaves);
    };
    EXPECT_EQ(pairs(24), std::pair(std::size_t(24), std::size_t(24 * 23 / 2))) << "each meets 23 others";
    EXPECT_EQ(pairs(25), std::pair(std::size_t(25), std::size_t(0))) << "each meets 24 others";
}

TEST(Intersection, ThatNobodyAsksForIsLetGoOf) {
    const SceneRule& rule = rule_of<SceneRule>("intersection");
    const auto ball = sphere(8).surface(), brick = box().surface();
    const auto find = [&](double shift) {
        const Scene scene({{ball, dmat4(1.0), 1}, {brick, moved({0.5, 0.5, shift}), 2}});
        const std::vector<Index> drawn = {0, 1};
        return rule.find(scene, drawn, {1, 0}, Cancel()).at(0).curves;
    };
    const std::weak_ptr<const KeptCurves> first = find(0.5);
    for (int frame = 0; frame < 10; ++frame) find(0.4);
    EXPECT_FALSE(first.expired());
    for (int frame = 0; frame < 10; ++frame) find(0.4);
    EXPECT_TRUE(first.expired());
}

TEST(Intersection, FlattenedAndHiddenObjectsDoNoHarm) {
    const Found flat({put(box(), scaled({2, 2, 0}), 1), put(box(), turned(0.5, {1, 0, 0}), 2)});
    EXPECT_GT(flat.length, 4.0) << "a box flattened to a sheet through a box";
    const Found two({put(box(), scaled({1, 1, 0}), 1), put(box(), scaled({1, 0, 1}), 2)});
    EXPECT_NEAR(two.length, 4 * 2.0, 0.01) << "two sheets: a line where two of their sides meet";
    EXPECT_EQ(Found({put(box(), scaled(dvec3(0)), 1), put(box(), scaled({1, 0, 0}), 2)}).count, 0u);
    EXPECT_EQ(Found({put(box(), scaled(dvec3(1e30)), 1), put(box(), dmat4(1.0), 2)}).count, 0u);
    EXPECT_EQ(Found({place(box(), dmat4(1.0), 1, usage_occlude), put(box(), moved(dvec3(0.5)), 2)}).count, 0u);
    const double nan = std::numeric_limits<double>::quiet_NaN();
    EXPECT_EQ(
        Found({put(box(), moved({nan, 0, 0}), 1), put(box(), moved(dvec3(0.5)), 2), put(box(), dmat4(1.0), 3)}).count,
        1u);
    const Found far({put(box(vec3(1e5f), vec3(1e5f + 4)), moved(dvec3(-1e5)), 1), put(box(), dmat4(1.0), 2)});
    EXPECT_EQ(far.closed, 1u) << "a mesh far from its origin";
    EXPECT_EQ(Found({put(Mesh("empty", {}), dmat4(1.0), 1), put(box(), dmat4(1.0), 2)}).count, 0u);
}
