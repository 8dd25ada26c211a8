// SPDX-License-Identifier: GPL-3.0-or-later
// Which stretches of chains are lines.
#include <gtest/gtest.h>
#include <set>

#include <fovea/path/find_curves.h>
#include <fovea/path/hysteresis.h>

#include "analytic.h"
#include "drawing.h"
#include "rules.h"

using namespace fovea;
using namespace fovea::draw;
using namespace fovea::drawing;

namespace {

/// A chain along x, points 1 apart, one triangle for each; closed: its last point repeats the first.
CurveChains chain_of(const std::vector<float>& strengths, bool closed = false) {
    CurveChains chains;
    for (std::size_t i = 0; i < strengths.size(); ++i) {
        const bool last = i + 1 == strengths.size();
        const double angle = 2 * M_PI * double(i) / double(strengths.size() - 1);
        chains.point.push_back(closed ? vec3(std::cos(angle), std::sin(angle), 0) : vec3(float(i), 0, 0));
        chains.strength.push_back(strengths[i]);
        chains.triangle.push_back(Index(last && i > 0 ? i - 1 : i) + 10);
        chains.side.push_back(Index(i));
        chains.other.push_back(chains.triangle.back() + 100);
    }
    if (closed) chains.point.back() = chains.point.front();
    chains.closed.push_back(closed);
    chains.free.push_back(closed ? 0 : any_free);
    chains.anchor.push_back(std::uint64_t(3) << 32 | 10);
    chains.rows.offsets.push_back(Index(strengths.size()));
    return chains;
}

double length_of(const CurveChains& chains) {
    double sum = 0.0;
    for (Index c = 0; c < chains.rows.count(); ++c)
        for (Index i = chains.rows.begin(c); i + 1 < chains.rows.end(c); ++i)
            sum += glm::distance(chains.point[i], chains.point[i + 1]);
    return sum;
}

CurveChains curves(const Surface& surface, const char* name, const std::vector<std::pair<const char*, double>>& given) {
    const LineDefinition& definition = definition_called(name);
    Values values;
    for (const Parameter& p : definition.parameters) {
        values.push_back(p.value);
        for (const auto& [parameter, value] : given)
            if (std::string(parameter) == p.name) values.back() = value;
    }
    SurfaceView seen{.surface = surface};
    seen.eye_obj = glm::normalize(dvec3(.8, .5, 1));
    seen.orthographic = true;
    return curves_of(rule_of<CurveRule>(name), seen, values);
}

}  // namespace

TEST(Hysteresis, AChainWithAWeakMiddleStaysWhole) {
    const CurveChains kept = select_stretches(chain_of({.2f, .9f, .1f, .1f, .8f, .2f}), {.reach = 0.5f});
    ASSERT_EQ(kept.rows.count(), 1u);
    EXPECT_EQ(kept.rows.size(0), 6u);
    EXPECT_EQ(kept.strength[2], .1f) << "its own strength stays";
}

TEST(Hysteresis, AWeakChainGoesAndSoDoesAShortOne) {
    EXPECT_EQ(select_stretches(chain_of({.4f, .4f, .4f, .4f}), {.reach = 0.5f}).rows.count(), 0u);
    EXPECT_EQ(select_stretches(chain_of({.5f, .5f, .5f}), {.reach = 0.5f, .least = 2.5}).rows.count(), 0u);
    EXPECT_EQ(select_stretches(chain_of({.5f, .5f, .5f, .5f}), {.reach = 0.5f, .least = 2.5}).rows.count(), 1u);
    EXPECT_EQ(select_stretches(chain_of({1, 1, 1}), {.reach = 0.5f, .least = 2.5}).rows.count(), 1u)
        << "a stronger one may be shorter";
}

TEST(Hysteresis, WhatStaysOfAChainLiesInTheSameTrianglesOfBothSurfaces) {
    const CurveChains cut = select_stretches(chain_of({1, 1, 0, 0, 1, 1}), {.level = 0.5f, .reach = 0.5f});
    ASSERT_GT(cut.point.size(), 3u);
    ASSERT_EQ(cut.other.size(), cut.point.size());
    for (std::size_t i = 0; i < cut.other.size(); ++i) EXPECT_EQ(cut.other[i], cut.triangle[i] + 100) << i;
}

TEST(Hysteresis, CutsWhereTheStrengthCrossesTheLevel) {
    const CurveChains chains = chain_of({1, 1, 0, 0, 1, 1});
    const CurveChains cut = select_stretches(chains, {.level = 0.5f, .reach = 0.5f, .uniform = true});
    ASSERT_EQ(cut.rows.count(), 2u);
    EXPECT_FLOAT_EQ(cut.point[cut.rows.end(0) - 1].x, 1.5f);
    EXPECT_FLOAT_EQ(cut.point[cut.rows.begin(1)].x, 3.5f);
    EXPECT_EQ(cut.side[cut.rows.end(0) - 1], none) << "inside a triangle";
    EXPECT_NE(cut.anchor[0], cut.anchor[1]);
    EXPECT_EQ(cut.anchor[1] >> 32, 3u) << "of the same level";
    for (float s : cut.strength) EXPECT_EQ(s, 1.0f);
    const CurveChains over =
        select_stretches(chain_of({1, 1, .3f, 1, 1}), {.level = 0.5f, .depth = 0.25f, .reach = 0.5f});
    EXPECT_EQ(over.rows.count(), 1u) << "a shallow gap is noise";
}

TEST(Hysteresis, AClosedChainOpensWhereItIsCut) {
    const CurveChains whole = select_stretches(chain_of({1, 1, 1, 1, 1, 1}, true), {.level = 0.5f});
    ASSERT_EQ(whole.rows.count(), 1u);
    EXPECT_TRUE(whole.closed[0]);
    EXPECT_EQ(whole.point.front(), whole.point.back());
    for (const std::vector<float>& strengths :
         {std::vector<float>{1, 1, 0, 0, 1, 1, 1}, {0, 1, 1, 1, 1, 0, 0}, {1, 0, 0, 1, 1, 1, 1}}) {
        const CurveChains open = select_stretches(chain_of(strengths, true), {.level = 0.5f});
        ASSERT_EQ(open.rows.count(), 1u);
        EXPECT_FALSE(open.closed[0]);
        EXPECT_EQ(open.rows.size(0), 6u) << "four points and both ends";
        EXPECT_NEAR(length_of(open), 4.0, 1e-5) << "of six sides of length 1";
    }
    EXPECT_EQ(select_stretches(chain_of({0, 0, 0, 0}, true), {.level = 0.5f}).rows.count(), 0u);
}

TEST(Hysteresis, EndsAreFreeUnlessAnotherLineGoesOnThere) {
    std::vector<std::uint8_t> removed(20, 0);
    removed[12] = 1;
    const CurveChains chains = chain_of({1, 1, 1, 1, 1, 1});
    const auto bits = [](const CurveChains& of) { return std::vector<int>(of.free.begin(), of.free.end()); };
    EXPECT_EQ(bits(without_triangles(chains, removed)), std::vector<int>({any_free, any_free}));
    const CurveChains cut = without_triangles(chains, removed, true);
    EXPECT_EQ(bits(cut), std::vector<int>({free_start, free_end}));
    EXPECT_EQ(bits(select_stretches(cut, {.level = 0.5f})), bits(cut)) << "what is kept keeps its ends";
    EXPECT_EQ(bits(without_triangles(chain_of({1, 1, 1, 1, 1, 1}, true), removed, true)), std::vector<int>({0}));
}

TEST(Hysteresis, TrianglesLeaveTheirGapsInChains) {
    std::vector<std::uint8_t> removed(20, 0);
    const CurveChains chains = chain_of({1, 1, 1, 1, 1, 1});
    EXPECT_EQ(without_triangles(chains, removed).rows.count(), 1u);
    removed[12] = 1;
    const CurveChains left = without_triangles(chains, removed);
    ASSERT_EQ(left.rows.count(), 2u);
    EXPECT_NEAR(length_of(left), 4.0, 1e-6);
    for (Index t : left.triangle) EXPECT_NE(t, 12u);
}

TEST(Hysteresis, HooksGoFromTheEndsOfOpenChains) {
    const auto surface = meshes::grid(10).surface();  // sides of .2 and diagonals
    const auto bent = [&](std::size_t corner, double angle, bool from_start) {
        CurveChains chains = chain_of(std::vector<float>(20, 1.0f));
        for (std::size_t i = 0; i < 20; ++i) {
            const double past = 0.1 * std::max(0.0, double(i) - double(corner)),
                         before = 0.1 * double(std::min(i, corner));
            chains.point[i] = vec3(dvec3(before + past * std::cos(angle), past * std::sin(angle), 0));
        }
        if (from_start) std::reverse(chains.point.begin(), chains.point.end());
        return without_spurs(chains, *surface).point.size();
    };
    for (const bool from_start : {false, true}) {
        EXPECT_NEAR(double(bent(17, M_PI / 2, from_start)), 18.0, 1.0) << "to the corner, or the point before it";
        EXPECT_EQ(bent(17, M_PI / 4, from_start), 20u) << "a gentle turn";
        EXPECT_EQ(bent(10, M_PI / 2, from_start), 20u) << "a corner far from the end";
    }
}

TEST(Hysteresis, LowersThresholdsOfWholeLinesAlone) {
    // A line that is well above the threshold anywhere is drawn, and all of it; others are not.
    const auto surface = analytic::waves({.n = 96, .irregular = true}).mesh.surface();
    for (const char* name :
         {"ridge", "valley", "suggestive_contour", "apparent_ridge", "demarcating_curve", "laplacian_line"}) {
        constexpr double threshold = 0.005;
        const CurveChains hard = curves(*surface, name, {{"threshold", 1.5 * threshold}, {"low", 1}, {"length", 0}});
        const CurveChains soft = curves(*surface, name, {{"threshold", threshold}, {"low", .25}, {"length", 0}});
        ASSERT_GT(hard.rows.count(), 0u) << name;
        EXPECT_GE(length_of(soft), length_of(hard)) << name;
        const std::set<Index> kept(soft.triangle.begin(), soft.triangle.end());
        for (Index c = 0; c < hard.rows.count(); ++c)
            for (Index i = hard.rows.begin(c); i < hard.rows.end(c); ++i)
                EXPECT_TRUE(kept.count(hard.triangle[i])) << name;
        const CurveChains longer = curves(*surface, name, {{"threshold", threshold}, {"low", .25}, {"length", 10}});
        EXPECT_LE(longer.rows.count(), soft.rows.count()) << name;
        for (Index t : longer.triangle) EXPECT_TRUE(kept.count(t)) << name;
        EXPECT_EQ(curves(*surface, name, {{"threshold", threshold}, {"length", 1000}}).rows.count(), 0u) << name;
    }
}

TEST(Hysteresis, ApparentRidgesAndValleysAreAllThereIs) {
    const auto surface = analytic::waves({.n = 64, .irregular = true}).mesh.surface();
    SurfaceView seen{.surface = *surface};
    seen.eye_obj = glm::normalize(dvec3(.8, .5, 1));
    seen.orthographic = true;
    const auto found = [&](double ridges, double valleys) {
        std::set<Index> triangles;
        for (const CurvePiece& piece : rule_of<CurveRule>("apparent_ridge").find(seen, {.005, 1, 0, ridges, valleys}))
            triangles.insert(piece.triangle);
        return triangles;
    };
    const auto ridges = found(1, 0), valleys = found(0, 1);
    EXPECT_GT(ridges.size(), 100u);
    EXPECT_GT(valleys.size(), 100u);
    EXPECT_TRUE(found(0, 0).empty());
    for (Index t : ridges) EXPECT_EQ(valleys.count(t), 0u);
    auto both = ridges;
    both.insert(valleys.begin(), valleys.end());
    EXPECT_EQ(both, found(1, 1));
}
