// SPDX-License-Identifier: GPL-3.0-or-later
// Folds of rounded surfaces, and the turns beside edges that they stand out against.
#include <algorithm>
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>
#include <gtest/gtest.h>
#include <numbers>
#include <set>

#include <fovea/field/fields.h>
#include <fovea/line/folds.h>
#include <fovea/line/turns.h>

#include "meshes.h"
#include "rules.h"

using namespace fovea;
using namespace fovea::meshes;
using line::Turns;

namespace {

using Ends = std::set<std::pair<Index, Index>>;

/// Pairs of vertices, the lesser first.
Ends folds(const Mesh& mesh, double least = 0.0, Shape shape = Shape::rounded, double angle = 30.0) {
    const auto surface = mesh.surface();
    std::function<bool(double)> is_short;
    if (least > 0.0) is_short = [&](double length) { return length < least; };
    const auto on = line::find_folds(field::FacetEdges(*surface), shape, angle, is_short);
    Ends found;
    for (Index e = 0; e < on.size(); ++e)
        if (on[e]) found.insert(std::minmax(surface->edges[e].x, surface->edges[e].y));
    return found;
}

Mesh inside_out(const Mesh& mesh) {
    return flipped(mesh, [](int) { return true; });
}

/// Every polygon as a fan of triangles.
Mesh in_triangles(const Mesh& mesh) {
    Mesh split(mesh.name, mesh.positions);
    for (std::size_t f = 0; f + 1 < mesh.polygon_offsets.size(); ++f)
        for (int c = mesh.polygon_offsets[f] + 1; c + 1 < mesh.polygon_offsets[f + 1]; ++c)
            split.add_polygon(
                {mesh.corner_verts[mesh.polygon_offsets[f]], mesh.corner_verts[c], mesh.corner_verts[c + 1]});
    return split;
}

/// n squares along y of an outline in x and z, that turns to the left by `turns` degrees after each unit of length.
Mesh extruded(const std::vector<double>& turns, int n = 4) {
    std::vector<dvec3> outline{{0, 0, 0}, {1, 0, 0}};
    double angle = 0.0;
    for (const double turn : turns) {
        angle += glm::radians(turn);
        outline.push_back(outline.back() + dvec3(std::cos(angle), 0, std::sin(angle)));
    }
    Mesh mesh("extruded", {});
    for (int j = 0; j <= n; ++j)
        for (const dvec3& p : outline) mesh.positions.push_back(vec3(p + dvec3(0, j, 0)));
    const int across = int(outline.size());
    for (int j = 0; j < n; ++j)
        for (int i = 0; i + 1 < across; ++i) {
            const int v = i + across * j;
            mesh.add_polygon({v, v + 1, v + across + 1, v + across});
        }
    return mesh;
}

/// A groove of n edges along x = 0 that turns by about 50 degrees, between faces that turn by up to 30.
Mesh grooved(int n) {
    return relief(n, [&](double x, double y) {
        return 0.5 * std::abs(x) + 0.4 / n * std::sin(0.9 * n * x + 0.5) * std::cos(0.8 * n * y + 0.2);
    });
}

/// The edges of a relief along x = 0.
Ends middle(int n) {
    Ends ends;
    for (Index j = 0; j < Index(n); ++j) ends.insert({n / 2 + (n + 1) * j, n / 2 + (n + 1) * (j + 1)});
    return ends;
}

TEST(Turns, AlongsideARegularTubeAreThoseOfItsEdgesHoweverItIsSplitAndFaces) {
    for (const int n : {3, 8, 40})
        for (const Mesh& mesh : {cylinder(n), inside_out(cylinder(n)), in_triangles(cylinder(n))}) {
            const auto surface = mesh.surface();
            const field::FacetEdges edges(*surface);
            const Turns turns(edges);
            const double sign = mesh.corner_verts == inside_out(cylinder(n)).corner_verts ? -1.0 : 1.0;
            for (Index e = 0; e < surface->mesh_edges; ++e) {
                if (surface->edge_rows.size(e) != 2 || std::abs(turns[e]) < 1e-3) continue;
                EXPECT_NEAR(turns[e], sign * 2.0 * std::numbers::pi / n, 1e-5);
                EXPECT_NEAR(turns.alongside(e), 2.0 * std::numbers::pi / n, 1e-5);
                EXPECT_NEAR(turns.parallel(e), 2.0 * std::numbers::pi / n, 1e-5);
            }
        }
}

TEST(Turns, AlongsideAreTheMeanOfBothSidesAndOfOneWay) {
    const auto surface = extruded({20, 40, -50}).surface();
    const field::FacetEdges edges(*surface);
    const Turns turns(edges);
    const auto across = [&](Index v) {  // the first edge in y at the outline's vertex
        for (Index e = 0; e < surface->mesh_edges; ++e)
            if (surface->edges[e] == Edge{v, v + 5} || surface->edges[e] == Edge{v + 5, v}) return e;
        return none;
    };
    const double degree = glm::radians(1.0);
    EXPECT_NEAR(turns[across(1)], -20 * degree, 1e-5);
    EXPECT_NEAR(turns[across(2)], -40 * degree, 1e-5);
    EXPECT_NEAR(turns[across(3)], 50 * degree, 1e-5);
    EXPECT_NEAR(turns.alongside(across(1)), 20 * degree, 1e-5) << "none beyond the border, 40 degrees";
    EXPECT_NEAR(turns.alongside(across(2)), 10 * degree, 1e-5) << "20 degrees, and the other way";
    EXPECT_NEAR(turns.alongside(across(3)), 0.0, 1e-5) << "the other way, and none";
}

/// A floor of two polygons side by side, whose seam has `count` edges, with a wall along its left side.
Mesh floor_with_seam(int count) {
    Mesh mesh("floor", {{-1, 0, 0}, {-1, 1, 0}, {-1, 1, 1}, {-1, 0, 1}, {1, 0, 0}, {1, 1, 0}});
    std::vector<int> left{1, 0}, right{4, 5};
    for (int i = 0; i <= count; ++i) {
        left.push_back(int(mesh.positions.size()));
        mesh.positions.push_back({i % 2 ? 0.1f : -0.1f, float(i) / float(count), 0});
    }
    right.insert(right.end(), left.rbegin(), left.rend() - 2);
    mesh.add_polygon(left);
    mesh.add_polygon(right);
    mesh.add_polygon({0, 1, 2, 3});
    return mesh;
}

TEST(Turns, BesidePolygonsWithALongCommonSeamAreFoundInAFewSteps) {
    const auto surface = floor_with_seam(20000).surface();  // to look out of both again and again takes its cube
    const field::FacetEdges edges(*surface);
    const Turns turns(edges);
    const auto wall = Index(std::ranges::find(surface->edges, Edge(1, 0)) - surface->edges.begin());
    EXPECT_NEAR(std::abs(turns[wall]), std::numbers::pi / 2.0, 1e-6);
    EXPECT_EQ(turns.parallel(wall), 0.0);
    EXPECT_EQ(turns.alongside(wall), 0.0);
}

TEST(Folds, OfARoundedSurfaceAreItsGrooves) {
    for (const int n : {8, 12, 16}) EXPECT_EQ(folds(grooved(n)), middle(n)) << n;
    EXPECT_EQ(folds(extruded({42})).size(), 4u);
    EXPECT_TRUE(folds(inside_out(extruded({42}))).empty());
    const Mesh row = extruded({50, 20, 50, 20});
    EXPECT_EQ(folds(row).size(), 8u);
    EXPECT_TRUE(folds(extruded({50, 30, 50, 30})).size() < folds(row).size());
}

TEST(Folds, AreNotInARegularBowlOrTubeWhateverItsResolution) {
    for (int n = 2; n <= 40; ++n) {
        const Mesh bowl = relief(n, [](double x, double y) { return 2.0 * (x * x + y * y); });
        for (const double angle : {1.0, 10.0, 30.0}) {
            EXPECT_TRUE(folds(bowl, 0.0, Shape::rounded, angle).empty()) << n << " " << angle;
            EXPECT_TRUE(folds(inside_out(cylinder(n + 1)), 0.0, Shape::rounded, angle).empty()) << n << " " << angle;
        }
        for (const Mesh& mesh : {sphere(n + 1), in_triangles(sphere(n + 1))})
            EXPECT_TRUE(folds(inside_out(mesh)).empty()) << n;
    }
}

TEST(Folds, AreCornersButNotRoundedOnes) {
    EXPECT_EQ(folds(extruded({90})).size(), 4u);
    for (int k = 2; k <= 8; ++k) EXPECT_TRUE(folds(extruded(std::vector<double>(k, 90.0 / k))).empty()) << k;
}

TEST(Folds, StartInGroovesAThirdSharperThanTheyGoOn) {
    EXPECT_TRUE(folds(extruded({39})).empty());
    EXPECT_EQ(folds(extruded({41})).size(), 4u);
    EXPECT_TRUE(folds(extruded({41}), 0.0, Shape::rounded, 32.0).empty());
    const int n = 32;
    const Mesh deepening =
        relief(n, [](double x, double y) { return std::abs(x) * std::tan(glm::radians(17.5 + 5.0 * y)); });
    const auto surface = deepening.surface();
    const field::FacetEdges edges(*surface);
    const Turns turns(edges);
    Ends deep;
    int starts = 0;
    for (Index e = 0; e < surface->mesh_edges; ++e)
        if (-turns[e] >= glm::radians(30.0)) {
            deep.insert(std::minmax(surface->edges[e].x, surface->edges[e].y));
            if (-turns[e] >= glm::radians(40.0)) ++starts;
        }
    EXPECT_GT(starts, 0);
    EXPECT_GT(deep.size(), 2u * starts);
    EXPECT_LT(deep.size(), std::size_t(n));
    EXPECT_EQ(folds(deepening), deep);
}

/// Two strips of triangles that meet in a groove along y, which turns by so many degrees in each row of vertices.
Mesh trough(const std::vector<double>& degrees) {
    Mesh mesh("trough", {});
    for (std::size_t j = 0; j < degrees.size(); ++j) {
        const float y = 2.0f * float(j), high = float(std::tan(glm::radians(0.5 * degrees[j])));
        for (const vec3& p : {vec3(-1, y, high), vec3(0, y, 0), vec3(1, y, high)}) mesh.positions.push_back(p);
    }
    for (int v = 0; v + 3 < int(mesh.positions.size()); v += 3)
        for (const int k : {v, v + 1}) {
            mesh.add_polygon({k, k + 1, k + 4});
            mesh.add_polygon({k, k + 4, k + 3});
        }
    return mesh;
}

TEST(Folds, GoOnOverAFewEdgesThatTurnHalfAsMuch) {
    const auto with_gap = [](int edges, double degrees) {
        std::vector<double> rows(20, 60.0);
        for (int j = 0; j <= edges; ++j) rows[8 + j] = degrees;
        return folds(trough(rows));
    };
    Ends whole;
    for (Index j = 0; j < 19; ++j) whole.insert({3 * j + 1, 3 * j + 4});
    for (const int edges : {1, 2, 3, 4}) EXPECT_EQ(with_gap(edges, 20.0), whole) << edges;
    EXPECT_EQ(with_gap(5, 20.0).size(), whole.size() - 5);
    EXPECT_EQ(with_gap(4, 12.0).size(), whole.size() - 4) << "hardly any turn";
}

TEST(Folds, OfThreeEdgesInGroovesAreKeptHoweverShort) {
    for (const int edges : {1, 2, 3, 4}) {
        const Mesh groove = extruded({60}, edges);
        EXPECT_EQ(folds(groove).size(), std::size_t(edges));
        EXPECT_EQ(folds(groove, 1e3).size(), edges < 3 ? 0u : std::size_t(edges));
        EXPECT_TRUE(folds(groove, 1e3, Shape::smooth).empty());
    }
}

TEST(Folds, AskWhetherALengthIsShortOnlyWhereThatDecides) {
    const auto asked = [](const Mesh& mesh) {
        const auto surface = mesh.surface();
        std::set<double> lengths;
        line::find_folds(field::FacetEdges(*surface), Shape::rounded, 30.0,
                         [&](double length) { return lengths.insert(length), false; });
        return lengths;
    };
    EXPECT_EQ(asked(extruded({60}, 2)), std::set<double>{2.0});
    EXPECT_TRUE(asked(extruded({60}, 3)).empty());  // grooves of three edges are kept however short
    EXPECT_TRUE(asked(extruded({60}, 1)).empty());  // one edge is left out whatever its length
    EXPECT_TRUE(asked(extruded({5, 5}, 8)).empty());
}

TEST(Folds, ThatAreLongAreCreasesWithoutFields) {
    Mesh groove = extruded({60}, 2);  // two units long, in a sphere of less
    groove.shape = Shape::rounded;
    for (const double least : {6.0, 100.0}) {  // in sizes of features, of a twentieth of the radius at most
        const auto surface = groove.surface();
        const auto& crease = rule_of<draw::EdgeRule>("crease");
        EXPECT_EQ(crease.find({.surface = *surface}, {30.0, 1.0, least}).size(), least < 10.0 ? 2u : 0u);
        EXPECT_EQ(fields_reason(*surface).empty(), least < 10.0);
    }
}

TEST(Folds, AreThoseOfTheShapeWhateverItsSizePlaceAndOrder) {
    const Mesh mesh = grooved(12);
    const Ends expected = folds(mesh);
    const dmat4 turn = glm::rotate(dmat4(1.0), 0.7, dvec3(1, 2, 3));
    for (const double size : {1e-3, 1.0, 1e3}) {
        Mesh other = mesh;
        for (vec3& p : other.positions) p = vec3(dmat3(turn) * (size * (dvec3(p) + dvec3(3, -2, 1))));
        EXPECT_EQ(folds(other), expected) << size;
    }
    Mesh backwards(mesh.name, mesh.positions);
    for (int c = int(mesh.corner_verts.size()); c > 0; c -= 3)
        backwards.add_polygon({mesh.corner_verts[c - 2], mesh.corner_verts[c - 1], mesh.corner_verts[c - 3]});
    EXPECT_EQ(folds(backwards), expected);
}

}  // namespace
