// SPDX-License-Identifier: GPL-3.0-or-later
// Curves across triangles: pieces where they should be, chained by what they cross.
#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <map>
#include <random>
#include <set>

#include <fovea/line/cluster_trace.h>
#include <fovea/path/chain_curves.h>

#include "meshes.h"

using namespace fovea;
using namespace fovea::draw;
using namespace fovea::meshes;

namespace {

const auto everywhere = [](Index) { return true; };
const auto sure = [](Index) { return 1.0f; };
const auto full = [](float) { return 1.0f; };

template <typename Value>
CurveChains zero_set(const Surface& surface, const Value& value) {
    return chain_curves(
        trace_zero_set(surface, [&](Index v) { return float(value(surface.positions[v])); }, sure, full));
}

double length(const CurveChains& chains) {
    double sum = 0.0;
    for (Index c = 0; c < chains.rows.count(); ++c)
        for (Index i = chains.rows.begin(c); i + 1 < chains.rows.end(c); ++i)
            sum += glm::distance(dvec3(chains.point[i]), dvec3(chains.point[i + 1]));
    return sum;
}

}  // namespace

TEST(TriangleSides, EverySideHasOneNumber) {
    for (const Mesh& mesh : {box(), sphere(12), bent_quad(), l_shape(), grid(5)}) {
        const auto surface = mesh.surface();
        const auto sides = triangle_sides(*surface);
        std::map<std::pair<Index, Index>, Index> numbers;
        for (std::size_t t = 0; t < surface->triangles.size(); ++t)
            for (int i = 0; i < 3; ++i) {
                const Index a = surface->triangles[t][i], b = surface->triangles[t][(i + 1) % 3];
                const Index side = sides->of_triangle[t][i];
                ASSERT_LT(side, sides->vertices.size());
                EXPECT_EQ(sides->vertices[side], Edge(std::min(a, b), std::max(a, b)));
                EXPECT_EQ(numbers.try_emplace({std::min(a, b), std::max(a, b)}, side).first->second, side);
            }
        EXPECT_EQ(numbers.size(), sides->vertices.size());
    }
}

TEST(ZeroSet, APlaneCutsASphereInOneClosedCircle) {
    const auto surface = sphere(48).surface();
    const double radius = glm::length(dvec3(surface->positions[0]));
    for (const double height : {0.0, 0.3, -0.55}) {
        const CurveChains circle = zero_set(*surface, [&](const vec3& p) { return p.x - height * radius; });
        ASSERT_EQ(circle.rows.count(), 1u) << height;
        EXPECT_TRUE(circle.closed[0]);
        EXPECT_EQ(circle.point.front(), circle.point.back());
        EXPECT_NEAR(length(circle) / radius, 2 * M_PI * std::sqrt(1 - height * height), 0.02);
        for (const vec3& p : circle.point) EXPECT_NEAR(p.x, height * radius, 1e-5);
    }
}

TEST(ZeroSet, ALineThroughTheVerticesOfAGridIsOneLine) {
    // The zero lies exactly on vertices: simulation of simplicity leaves no gap and no double.
    const auto surface = grid(8).surface();
    const CurveChains line = zero_set(*surface, [](const vec3& p) { return p.x; });
    ASSERT_EQ(line.rows.count(), 1u);
    EXPECT_FALSE(line.closed[0]);
    const float low = surface->positions[0].y;
    EXPECT_NEAR(length(line), 2 * std::abs(low), 1e-5);
}

TEST(ZeroSet, IsTheSameFromBothSides) {
    const auto surface = sphere(24).surface();
    const auto field = [](const vec3& p) { return p.x + 0.3f * p.y * p.z - 0.1f; };
    const CurveChains a = zero_set(*surface, field), b = zero_set(*surface, [&](const vec3& p) { return -field(p); });
    EXPECT_EQ(a.rows.offsets, b.rows.offsets);
    EXPECT_NEAR(length(a), length(b), 1e-5);
}

TEST(ZeroSet, OnlyWhatIsAboveTheMarginIsKept) {
    const auto surface = grid(16).surface();
    const float half = std::abs(surface->positions[0].x);
    const auto x = [&](Index v) { return surface->positions[v].x - 0.013f * half; };
    const auto margin = [&](Index v) { return surface->positions[v].y - 0.21f * half; };
    const CurveChains line = chain_curves(trace_zero_set(*surface, x, margin, [&](float m) { return m; }));
    ASSERT_EQ(line.rows.count(), 1u);
    EXPECT_NEAR(length(line), 0.79 * half, 1e-5);
    for (std::size_t i = 0; i < line.point.size(); ++i)
        EXPECT_NEAR(line.strength[i], line.point[i].y - 0.21f * half, 1e-5);
}

TEST(ZeroSet, NaNAndBrokenTrianglesGiveNoLine) {
    const auto surface = grid(4).surface();
    const float nan = std::nanf("");
    EXPECT_EQ(zero_set(*surface, [&](const vec3&) { return nan; }).rows.count(), 0u);
    const CurveChains part = zero_set(*surface, [&](const vec3& p) { return p.y > 0 ? nan : p.x - 0.01f; });
    for (const vec3& p : part.point) EXPECT_TRUE(std::isfinite(p.x + p.y + p.z));
    // Margins and derivatives without bounds.
    const auto x = [&](Index v) { return surface->positions[v].x - 0.01f; };
    const auto margin = [&](Index v) { return surface->positions[v].y > 0 ? infinity : -infinity; };
    const auto uphill = [&](Index v) { return vec3(x(v) > 0 ? -infinity : infinity, 0, 0); };
    for (const Curves& curves :
         {trace_zero_set(*surface, x, margin, full), trace_maxima(*surface, everywhere, uphill, 0.0f, sure, full)})
        for (const CurvePiece& p : curves)
            for (int k = 0; k < 2; ++k)
                EXPECT_TRUE(std::isfinite(p.point[k].x + p.point[k].y + p.point[k].z + p.strength[k]));
}

TEST(ZeroSet, LevelsAreCurvesOfTheirOwn) {
    // Three levels may cross the same side; each is one circle.
    const auto surface = sphere(8).surface();
    const auto nowhere = [](const SeenCluster&) { return false; };
    const auto height = [&](Index v) { return surface->positions[v].z; };
    const CurveChains circles = chain_curves(trace_levels({.surface = *surface}, nowhere, height, {0.05f, 0.02f, 3}));
    ASSERT_EQ(circles.rows.count(), 3u);
    EXPECT_EQ(std::set(circles.anchor.begin(), circles.anchor.end()).size(), 3u);
    for (Index c = 0; c < 3; ++c) {
        EXPECT_TRUE(circles.closed[c]);
        for (Index i = circles.rows.begin(c); i < circles.rows.end(c); ++i)
            EXPECT_NEAR(circles.point[i].z, circles.point[circles.rows.begin(c)].z, 1e-6);
    }
}

TEST(Maxima, OfARidgedFieldIsTheRidgeWhicheverWayItsVectorsTurn) {
    // The quantity -(x - a)^2 grows towards x = a; its derivative along (1,0,0) or (-1,0,0) turns around with it.
    const auto surface = grid(16).surface();
    const float half = std::abs(surface->positions[0].x), at = 0.137f * half;
    const auto uphill = [&](Index v) { return vec3(2.0f * (at - surface->positions[v].x), 0, 0); };
    const CurveChains ridge = chain_curves(trace_maxima(*surface, everywhere, uphill, 0.0f, sure, full));
    ASSERT_EQ(ridge.rows.count(), 1u);
    EXPECT_NEAR(length(ridge), 2 * half, 1e-4);
    for (const vec3& p : ridge.point) EXPECT_NEAR(p.x, at, 1e-5);
    // A minimum is no line, and neither is a maximum that is too flat.
    const auto downhill = [&](Index v) { return -uphill(v); };
    EXPECT_TRUE(trace_maxima(*surface, everywhere, downhill, 0.0f, sure, full).empty());
    EXPECT_TRUE(trace_maxima(*surface, everywhere, uphill, 2.1f, sure, full).empty());
    EXPECT_FALSE(trace_maxima(*surface, everywhere, uphill, 1.9f, sure, full).empty());
}

TEST(ChainCurves, PiecesFollowOneAnotherInAnyOrder) {
    const auto surface = sphere(32).surface();
    Curves pieces = trace_zero_set(*surface, [&](Index v) { return surface->positions[v].x - 0.1f; }, sure, full);
    std::reverse(pieces.begin(), pieces.end());
    for (std::size_t i = 0; i < pieces.size(); i += 2) {
        std::swap(pieces[i].side[0], pieces[i].side[1]);
        std::swap(pieces[i].point[0], pieces[i].point[1]);
    }
    const CurveChains chains = chain_curves(pieces);
    ASSERT_EQ(chains.rows.count(), 1u);
    EXPECT_TRUE(chains.closed[0]);
    EXPECT_EQ(chains.point.size(), pieces.size() + 1);
    EXPECT_EQ(chain_curves({}).rows.count(), 0u);
}

TEST(ChainCurves, ExactlyTwoEndsOnASideAreLinked) {
    // Random pieces, sides of one to many ends, three levels: as many chains as a map of the sides says.
    std::mt19937 random(11);
    for (const unsigned sides : {3u, 40u, 5000u}) {
        Curves pieces;
        std::map<std::pair<Index, Index>, int> ends;
        for (Index i = 0; i < 3000; ++i) {
            CurvePiece piece{i, {Index(random() % sides), 0}, {vec3(i), vec3(i)}, {1.0f, 1.0f}, Index(random() % 3)};
            piece.side[1] = random() % 5 ? (piece.side[0] + 1 + random() % (sides - 1)) % sides : none;
            for (const Index side : piece.side)
                if (side != none) ++ends[{piece.level, side}];
            pieces.push_back(piece);
        }
        const auto links = std::count_if(ends.begin(), ends.end(), [](const auto& side) { return side.second == 2; });
        const CurveChains chains = chain_curves(pieces);
        const auto closed = std::count(chains.closed.begin(), chains.closed.end(), 1);
        EXPECT_EQ(chains.rows.count(), pieces.size() - links + closed);
        EXPECT_EQ(chains.point.size(), pieces.size() + chains.rows.count());
    }
}
