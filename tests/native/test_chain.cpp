// SPDX-License-Identifier: GPL-3.0-or-later
// Edges chained into paths: corners, junctions, loops, and who is first.
#include <gtest/gtest.h>

#include <fovea/path/chain.h>

#include "drawing.h"

using namespace fovea;
using namespace fovea::draw;
using namespace fovea::meshes;
using namespace fovea::drawing;

namespace {

/// Edges without polygons, as (from, to) pairs of vertices.
Mesh wire(const std::vector<vec3>& points, const std::vector<std::pair<int, int>>& edges) {
    Mesh mesh("wire", points);
    for (const auto& [a, b] : edges) mesh.edge(a, b);
    return mesh;
}

vec3 on_circle(double degrees) {
    const double a = glm::radians(degrees);
    return vec3(dvec3(std::cos(a), std::sin(a), 0));
}

/// All edges of the mesh under one label.
Chains chain_all(const Mesh& mesh, double corner_degrees, std::vector<std::uint8_t> labels = {}) {
    std::vector<Index> edges(mesh.edge_verts.size());
    for (Index e = 0; e < edges.size(); ++e) edges[e] = e;
    labels.resize(edges.size(), 0);
    const std::vector<double> angles(4, glm::radians(corner_degrees));
    const auto surface = mesh.surface();
    return chain(SurfaceView{.surface = *surface}, false, edges, labels, angles);
}

/// The set of edges of each chain.
std::set<std::set<Index>> groups(const Chains& chains) {
    std::set<std::set<Index>> result;
    for (Index c = 0; c < chains.rows.count(); ++c)
        result.insert(
            std::set<Index>(chains.edge.begin() + chains.rows.begin(c), chains.edge.begin() + chains.rows.end(c)));
    return result;
}

using Groups = std::set<std::set<Index>>;

}  // namespace

TEST(Chain, SplitsWhereItTurnsByMoreThanTheCornerAngle) {
    for (const double turn : {10.0, 45.0, 90.0, 135.0}) {
        const vec3 next = vec3(1, 0, 0) + on_circle(turn);
        const Mesh bend = wire({{0, 0, 0}, {1, 0, 0}, next}, {{0, 1}, {1, 2}});
        EXPECT_EQ(chain_all(bend, turn + 0.1).rows.count(), 1u) << turn;
        EXPECT_EQ(chain_all(bend, turn - 0.1).rows.count(), 2u) << turn;
    }
}

TEST(Chain, AtACornerAngleOf180DegreesNothingSplitsIt) {
    for (int k = 0; k < 200; ++k) {
        const vec3 way(std::cos(3.7f * k), std::sin(2.3f * k), std::cos(1.1f * k));
        const Mesh back = wire({{0, 0, 0}, way, 0.3f * way}, {{0, 1}, {1, 2}});
        EXPECT_EQ(chain_all(back, 180).rows.count(), 1u) << k;
    }
}

TEST(Chain, GoesStraightOnThroughACrossing) {
    const Mesh x = wire({{0, 0, 0}, on_circle(0), on_circle(80), on_circle(185), on_circle(260)},
                        {{0, 1}, {2, 0}, {0, 3}, {4, 0}});
    EXPECT_EQ(groups(chain_all(x, 60)), (Groups{{0, 2}, {1, 3}}));
}

TEST(Chain, AtATTheStraightLineGoesOnAndTheThirdEnds) {
    const Mesh t = wire({{0, 0, 0}, on_circle(0), on_circle(100), on_circle(180)}, {{0, 1}, {0, 2}, {0, 3}});
    EXPECT_EQ(groups(chain_all(t, 60)), (Groups{{0, 2}, {1}}));
    EXPECT_EQ(groups(chain_all(t, 180)), (Groups{{0, 2}, {1}})) << "one partner only";
}

TEST(Chain, WhatIsStraighterComesFirst) {
    // 1 continues 0 within 20 degrees, 2 within 5.
    const Mesh y = wire({{0, 0, 0}, on_circle(180), on_circle(20), on_circle(-5)}, {{1, 0}, {0, 2}, {0, 3}});
    EXPECT_EQ(groups(chain_all(y, 60)), (Groups{{0, 2}, {1}}));
}

TEST(Chain, LoopsAreClosedAndRepeatTheirFirstPoint) {
    std::vector<vec3> points;
    std::vector<std::pair<int, int>> edges;
    for (int i = 0; i < 12; ++i) {
        points.push_back(on_circle(30.0 * i));
        edges.push_back(i % 2 ? std::pair(i, (i + 1) % 12) : std::pair((i + 1) % 12, i));  // both directions
    }
    const Chains loop = chain_all(wire(points, edges), 45);
    ASSERT_EQ(loop.rows.count(), 1u);
    EXPECT_TRUE(loop.closed[0]);
    EXPECT_EQ(loop.vertex.size(), 13u);
    EXPECT_EQ(loop.vertex.front(), loop.vertex.back());
    EXPECT_EQ(loop.anchor[0], 0u);
    const Chains polygon = chain_all(wire(points, edges), 29);
    EXPECT_EQ(polygon.rows.count(), 12u) << "each turn of 30 degrees is a corner";

    edges.pop_back();
    const Chains open = chain_all(wire(points, edges), 45);
    ASSERT_EQ(open.rows.count(), 1u);
    EXPECT_FALSE(open.closed[0]);
}

TEST(Chain, ALoopWithOneCornerIsOpenThere) {
    // A drop: round below, a tip of 90 degrees at the top.
    std::vector<vec3> points;
    std::vector<std::pair<int, int>> edges;
    for (int i = 0; i <= 18; ++i) points.push_back(on_circle(135.0 + 15.0 * i));
    points.push_back({0, std::sqrt(2.0f), 0});
    for (int i = 0; i < 20; ++i) edges.push_back({i, (i + 1) % 20});
    const Chains drop = chain_all(wire(points, edges), 60);
    ASSERT_EQ(drop.rows.count(), 1u);
    EXPECT_FALSE(drop.closed[0]);
    EXPECT_EQ(drop.vertex.front(), 19u);
    EXPECT_EQ(drop.vertex.back(), 19u);
}

TEST(Chain, TurnsOfViewDependentLinesAreMeasuredInTheImage) {
    // A zigzag in depth, straight to a viewer who looks down.
    const Mesh zigzag = wire({{-1, 0, 0}, {0, 0, 1}, {1, 0, 0}}, {{0, 1}, {1, 2}});
    const auto surface = zigzag.surface();
    const std::vector<Index> edges{0, 1};
    const std::vector<std::uint8_t> labels{0, 0};
    const std::vector<double> angle{glm::radians(10.0)};
    for (const bool ortho : {false, true}) {
        const auto paths_from = [&](dvec3 eye, bool in_image) {
            const SurfaceView seen{
                .surface = *surface, .orthographic = ortho, .object_to_view = look_at(eye, {0, 0, 0})};
            return chain(seen, in_image, edges, labels, angle).rows.count();
        };
        EXPECT_EQ(paths_from({0, 0, 5}, true), 1u);
        EXPECT_EQ(paths_from({0, 0, 5}, false), 2u);
        EXPECT_EQ(paths_from({0, -5, 0}, true), 2u) << "from the front it is a corner";
    }
}

TEST(Chain, EverySegmentLiesOnItsEdge) {
    const Mesh mesh = sphere(6);
    const Chains chains = chain_all(mesh, 60);
    std::vector<int> uses(mesh.edge_verts.size(), 0);
    for (Index c = 0; c < chains.rows.count(); ++c) {
        Index lowest = none;
        for (Index i = chains.rows.begin(c); i + 1 < chains.rows.end(c); ++i) {
            const glm::ivec2 edge = mesh.edge_verts[chains.edge[i]];
            EXPECT_EQ(std::minmax(chains.vertex[i], chains.vertex[i + 1]), std::minmax(Index(edge.x), Index(edge.y)));
            ++uses[chains.edge[i]];
            lowest = std::min(lowest, chains.edge[i]);
        }
        EXPECT_EQ(chains.anchor[c], lowest);
        EXPECT_EQ(chains.edge[chains.rows.end(c) - 1], chains.edge[chains.rows.end(c) - 2]) << "the last repeats";
    }
    EXPECT_EQ(std::count(uses.begin(), uses.end(), 1), std::ptrdiff_t(uses.size())) << "every edge once";
}

TEST(Chain, MoreThanThirtyTwoLinesAllEndAtTheirVertex) {
    for (const int n : {4, 32, 33, 34, 200}) {
        Mesh star("star", {{0, 0, 0}});
        for (int i = 0; i < n; ++i) {
            star.positions.push_back(on_circle(360.0 * i / n));
            star.edge(0, i + 1);
        }
        EXPECT_EQ(chain_all(star, 1).rows.count(), n <= 32 ? n / 2u : Index(n))
            << n << ": straight on in pairs, or not";
    }
}

TEST(Chain, LabelsAreChainedApart) {
    const Mesh line = wire({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {3, 0, 0}}, {{0, 1}, {1, 2}, {2, 3}});
    const Chains chains = chain_all(line, 60, {0, 1, 1});
    EXPECT_EQ(groups(chains), (Groups{{0}, {1, 2}}));
    for (Index c = 0; c < 2; ++c) EXPECT_EQ(chains.label[c], chains.anchor[c] == 0 ? 0 : 1);
}

TEST(Chain, NothingMakesNoChains) {
    EXPECT_EQ(chain_all(wire({}, {}), 60).rows.count(), 0u);
    EXPECT_EQ(chain_all(wire({{0, 0, 0}}, {}), 60).rows.count(), 0u);
    const Mesh point = wire({{0, 0, 0}, {0, 0, 0}}, {{0, 1}});
    EXPECT_EQ(chain_all(point, 60).rows.count(), 1u) << "an edge without length is still one";
    const Mesh self = wire({{0, 0, 0}, {1, 0, 0}}, {{0, 0}, {0, 1}});
    const Chains both = chain_all(self, 180);
    EXPECT_EQ(both.vertex.size() - both.rows.count(), 2u) << "an edge from a vertex to itself is walked once";
}
