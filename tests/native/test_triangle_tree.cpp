// SPDX-License-Identifier: GPL-3.0-or-later
// Pairs of triangles that may cross: none is passed over, of trees of any size and of triangles in any position.
#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <limits>
#include <random>
#include <set>

#include <fovea/scene/four_planes.h>

#include "intersections.h"

using namespace fovea;
using namespace fovea::draw;
using namespace fovea::intersections;

namespace {

using Triangles = std::vector<std::array<dvec3, 3>>;

/// Triangles of about the given size, their middles in the unit cube.
Triangles any_triangles(std::mt19937& random, int count, double size) {
    std::uniform_real_distribution<double> unit(-1, 1);
    const auto any = [&] {
        const double x = unit(random), y = unit(random), z = unit(random);
        return dvec3(x, y, z);
    };
    Triangles triangles(count);
    for (auto& t : triangles) {
        const dvec3 middle = any();
        for (dvec3& corner : t) corner = dvec3(vec3(middle + size * any()));
    }
    return triangles;
}

std::shared_ptr<Surface> surface_of(const Triangles& triangles) {
    Mesh mesh("triangles", {});
    for (const auto& t : triangles) {
        const int first = static_cast<int>(mesh.positions.size());
        for (const dvec3& corner : t) mesh.positions.push_back(vec3(corner));
        mesh.add_polygon({first, first + 1, first + 2});
    }
    return mesh.surface();
}

Box box_of(const std::array<dvec3, 3>& t) {
    return {vec3(glm::min(t[0], glm::min(t[1], t[2]))), vec3(glm::max(t[0], glm::max(t[1], t[2])))};
}

using Pairs = std::set<std::pair<Index, Index>>;

/// Pairs of triangles in the pairs of leaves that a meeting visits; each pair of leaves comes once.
Pairs met(const Surface& a, const Surface& b, const Affine& b_to_a, bool within) {
    const auto tree_a = triangle_tree(a), tree_b = triangle_tree(b);
    const SingleMap map(b_to_a, tree_b->bounds);
    const TreeMeeting meeting(*tree_a, *tree_b, map, 1e-6f, within);
    Pairs leaves, pairs;
    for (std::size_t block = 0; block < meeting.block_count(); ++block)
        meeting.block(block, [&](Index i, Index j) {
            EXPECT_TRUE(leaves.insert({i, j}).second) << i << " " << j;
            for (Index s = 4 * i; s < std::min<std::size_t>(4 * i + 4, tree_a->order.size()); ++s)
                for (Index t = 4 * j; t < std::min<std::size_t>(4 * j + 4, tree_b->order.size()); ++t)
                    if (!within || s < t) pairs.insert({tree_a->order[s], tree_b->order[t]});
        });
    return pairs;
}

/// Whether a side of one triangle passes through the other, by volumes that are far from 0.
bool surely_cross(const std::array<dvec3, 3>& a, const std::array<dvec3, 3>& b) {
    const auto volume = [](const dvec3& p, const dvec3& q, const dvec3& r, const dvec3& s) {
        return glm::dot(glm::cross(q - p, r - p), s - p);
    };
    const auto pierced = [&](const std::array<dvec3, 3>& by, const std::array<dvec3, 3>& t) {
        for (int k = 0; k < 3; ++k) {
            const dvec3 &from = by[k], &to = by[(k + 1) % 3];
            const double over = volume(t[0], t[1], t[2], from), under = volume(t[0], t[1], t[2], to);
            const double x = volume(from, to, t[0], t[1]), y = volume(from, to, t[1], t[2]),
                         z = volume(from, to, t[2], t[0]);
            if (over * under < 0.0 && ((x > 0.0 && y > 0.0 && z > 0.0) || (x < 0.0 && y < 0.0 && z < 0.0))) return true;
        }
        return false;
    };
    return pierced(a, b) || pierced(b, a);
}

FourTriangles four_of(const Triangles& triangles, std::size_t first) {
    FourTriangles four;
    for (int lane = 0; lane < 4; ++lane)
        for (int k = 0; k < 3; ++k)
            for (int axis = 0; axis < 3; ++axis)
                four.corner[k][axis][lane] = static_cast<float>(triangles[first + lane][k][axis]);
    return four;
}

/// Counts of pairs of triangles, the first four with the last four.
struct Counted {
    int crossing = 0, kept = 0, all = 0;

    /// `planes`, `others`: of the first four, and of the last. None that cross is passed over.
    void add(const FourPlanes& planes, const FourTriangles& others, const Triangles& triangles) {
        for (int j = 0; j < 4; ++j) {
            const unsigned may = planes.may_cross(15u, others, j);
            for (int i = 0; i < 4; ++i) {
                const bool cross = surely_cross(triangles[i], triangles[4 + j]);
                EXPECT_TRUE(!cross || (may >> i & 1u));
                crossing += cross;
                kept += may >> i & 1u;
                ++all;
            }
        }
    }
};

}  // namespace

TEST(TriangleTree, AllTrianglesWhoseBoxesOverlapMeet) {
    std::mt19937 random(3);
    const Affine map = Affine(moved({0.3, -0.2, 0.1}) * turned(0.7, {1, 2, 3}) * scaled({1.5, 0.5, -1}));
    for (const int count : {1, 3, 4, 5, 16, 17, 64, 65, 300})
        for (const int others : {1, 4, 21, 290})
            for (const double size : {0.01, 0.1, 1.0}) {
                const Triangles first = any_triangles(random, count, size),
                                second = any_triangles(random, others, size);
                const auto a = surface_of(first), b = surface_of(second);
                const Pairs pairs = met(*a, *b, map, false);
                for (Index s = 0; s < first.size(); ++s)
                    for (Index t = 0; t < second.size(); ++t) {
                        std::array<dvec3, 3> image;
                        for (int k = 0; k < 3; ++k) image[k] = map * dvec4(second[t][k], 1.0);
                        const bool overlap = box_of(first[s]).meets(box_of(image));
                        EXPECT_TRUE(!overlap || pairs.contains({s, t})) << count << " " << others << " " << size;
                    }
                // Of those that are far from each other few meet.
                EXPECT_TRUE(count < 300 || others < 290 || size > 0.01 || pairs.size() < 300u * 290u / 4u);
            }
}

TEST(TriangleTree, WithinASurfaceEveryPairMeetsOnce) {
    std::mt19937 random(4);
    for (const int count : {1, 2, 4, 5, 9, 16, 17, 64, 65, 300}) {
        const Triangles triangles = any_triangles(random, count, 0.1);
        const auto surface = surface_of(triangles);
        const Pairs pairs = met(*surface, *surface, Affine(1.0), true);
        for (const auto& [s, t] : pairs) EXPECT_FALSE(pairs.contains({t, s}));
        for (Index s = 0; s < triangles.size(); ++s)
            for (Index t = 0; t < s; ++t)
                EXPECT_TRUE(!box_of(triangles[s]).meets(box_of(triangles[t])) || pairs.contains({s, t}) ||
                            pairs.contains({t, s}))
                    << count;
    }
}

TEST(FourPlanes, NoneThatCrossIsPassedOverAndMostOthersAre) {
    std::mt19937 random(5);
    for (const double scale : {1e-30, 1e-15, 1e-6, 1.0, 1e6, 1e15}) {
        SCOPED_TRACE(scale);
        Counted counted;
        for (int round = 0; round < 2000; ++round) {
            Triangles triangles = any_triangles(random, 8, 1.0);
            for (auto& t : triangles)
                for (dvec3& corner : t) corner = dvec3(vec3(scale * corner));
            const FourTriangles ours = four_of(triangles, 0), others = four_of(triangles, 4);
            counted.add(FourPlanes(ours, 0.0f, false), others, triangles);
        }
        EXPECT_GT(counted.crossing, counted.all / 20);
        // Elsewhere products of lengths leave the range of single precision.
        EXPECT_TRUE(scale < 1e-6 || scale > 1e6 || counted.kept < 1.001 * counted.crossing)
            << scale << ": " << counted.kept;
    }
}

TEST(FourPlanes, TheErrorOfCoordinatesIsHeeded) {
    std::mt19937 random(6);
    std::uniform_real_distribution<double> unit(-1, 1);
    const float error = 0.05f;
    int grazing = 0;
    for (int round = 0; round < 20000; ++round) {
        const Triangles triangles = any_triangles(random, 8, 0.5);
        Triangles there = triangles;
        for (auto& t : there)
            for (dvec3& corner : t)
                for (int axis = 0; axis < 3; ++axis) corner[axis] += error * unit(random);
        const FourTriangles ours = four_of(triangles, 0), others = four_of(triangles, 4);
        const FourPlanes planes(ours, error, false);
        const unsigned may = planes.may_cross(15u, others, 0);
        for (int i = 0; i < 4; ++i) {
            const bool cross = surely_cross(there[i], there[4]);
            EXPECT_TRUE(!cross || (may >> i & 1u));
            grazing += cross && !surely_cross(triangles[i], triangles[4]);
        }
    }
    EXPECT_GT(grazing, 100) << "there are pairs that cross only when they are moved";
}

TEST(FourPlanes, NeighborsAtASmoothVertexDoNotCrossAndThoseOfAFoldMay) {
    // A fan around the tip of a cone; then one of its triangles is turned through another one.
    const auto at = [](double angle) { return dvec3(std::cos(angle), std::sin(angle), -0.5); };
    Triangles fan;
    for (int i = 0; i < 8; ++i) fan.push_back({dvec3(0.0), at(0.7 * i), at(0.7 * (i + 1))});
    fan[6] = {dvec3(0.0), dvec3(0.8, 0.3, 1.0), dvec3(0.8, 0.3, -2.0)};
    const FourTriangles ours = four_of(fan, 0), others = four_of(fan, 4);
    const FourPlanes within(ours, 0.0f, true);
    EXPECT_EQ(within.may_cross(15u, others, 0), 0u);  // 3 and 4 have a side in common
    EXPECT_EQ(within.may_cross(15u, others, 1), 0u);
    EXPECT_EQ(within.may_cross(15u, others, 2), 1u);  // goes through the first
}

TEST(FourPlanes, TrianglesWhoseCutsGoApartFromACommonCornerAreLeftOut) {
    std::mt19937 random(7);
    Counted counted;
    for (int round = 0; round < 5000; ++round) {
        Triangles triangles = any_triangles(random, 8, 1.0);
        for (auto& t : triangles) {
            for (dvec3& corner : t) corner = dvec3(vec3(corner));
            t[0] = triangles[0][0];
        }
        Triangles turned = triangles;  // the common corner is any of theirs
        for (std::size_t i = 0; i < 8; ++i) std::ranges::rotate(turned[i], turned[i].begin() + (round + i * i) % 3);
        const FourTriangles ours = four_of(turned, 0), others = four_of(turned, 4);
        counted.add(FourPlanes(ours, 0.0f, true), others, triangles);
    }
    EXPECT_GT(counted.crossing, counted.all / 20);
    EXPECT_LT(counted.kept, 1.01 * counted.crossing);
}

TEST(BoxTree, FindsWhatMeetsAnEndlessBoxAndNothingElse) {
    constexpr float endless = std::numeric_limits<float>::infinity();
    for (const std::size_t count : {1, 2, 5, 17, 70}) {
        Array<Box> boxes;
        for (std::size_t i = 0; i < count; ++i) boxes.push_back({vec3(float(i)), vec3(float(i) + 0.5f)});
        const BoxTree tree(boxes);
        const auto met = [&](const Box& box) {
            std::set<Index> found;
            tree.each_meeting(box, [&](Index i) { return found.insert(i).second; });
            return found;
        };
        EXPECT_EQ(met({vec3(-endless), vec3(endless)}).size(), count);
        EXPECT_EQ(met({vec3(0.25f), vec3(0.3f)}), (std::set<Index>{0}));
        EXPECT_TRUE(met({vec3(-2.0f), vec3(-1.0f)}).empty());
        int asked = 0;
        tree.each_meeting({vec3(-endless), vec3(endless)}, [&](Index) { return ++asked < 2; });
        EXPECT_EQ(asked, std::min<int>(2, int(count)));
    }
}
