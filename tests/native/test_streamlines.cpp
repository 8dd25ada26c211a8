// SPDX-License-Identifier: GPL-3.0-or-later
// Directions in which surfaces bend, and evenly spaced curves along them: on cylinders and tori they are those of
// greatest curvature, known in closed form; curves keep their distance; coarser levels are among finer ones.
#include <array>
#include <gtest/gtest.h>
#include <map>
#include <numbers>
#include <set>

#include <fovea/field/bend_directions.h>
#include <fovea/line/streamlines.h>

#include "meshes.h"

using namespace fovea;
using namespace fovea::field;
using namespace fovea::line;
using namespace fovea::mesh;
using namespace fovea::meshes;

namespace {

constexpr double pi = std::numbers::pi;

/// Quads between n x m places of a surface that closes in both directions, or in the first alone.
template <typename At>
Mesh closed_sheet(int n, int m, bool second_closes, const At& at) {
    std::vector<vec3> positions;
    Polygons polygons;
    const int rows = second_closes ? m : m + 1;
    for (int j = 0; j < rows; ++j)
        for (int i = 0; i < n; ++i) positions.push_back(vec3(at(2.0 * pi * i / n, double(j) / m)));
    for (int j = 0; j < m; ++j)
        for (int i = 0; i < n; ++i) {
            const int k = (i + 1) % n, l = (j + 1) % rows;
            polygons.push_back({j * n + i, j * n + k, l * n + k, l * n + i});
        }
    return of_polygons("sheet", positions, polygons);
}

/// Open, of radius 1, along Z from -height / 2 to height / 2.
Mesh tube(int n, int m, double height = 4.0) {
    return closed_sheet(n, m, false,
                        [&](double a, double t) { return dvec3(std::cos(a), std::sin(a), height * (t - 0.5)); });
}

/// Around Z, of radii 1 and `thin`. The first parameter turns around the tube.
Mesh torus(int n, int m, double thin = 0.3) {
    return closed_sheet(n, m, true, [&](double a, double t) {
        const double r = 1.0 + thin * std::cos(a);
        return dvec3(r * std::cos(-2.0 * pi * t), r * std::sin(-2.0 * pi * t), thin * std::sin(a));
    });
}

struct Piece {
    Index curve, triangle;
    int power;
    dvec3 from, to;
    double length() const { return glm::distance(from, to); }
};

std::vector<Piece> pieces(const Surface& surface, double degrees, int power) {
    std::vector<Piece> found;
    const auto lines = streamlines(surface, std::array{glm::radians(degrees)}, power).front();
    for (Index t = 0; t < surface.triangles.size(); ++t)
        for (const StreamChord& chord : (*lines)[t]) {
            dvec3 ends[2];
            for (const int k : {0, 1}) {
                ends[k] = dvec3(0.0);
                for (int c = 0; c < 3; ++c)
                    ends[k] += double(chord.weight[k][c]) * dvec3(surface.positions[surface.triangles[t][c]]);
            }
            found.push_back({chord.curve, t, chord.power, ends[0], ends[1]});
        }
    return found;
}

/// Of all pieces, by length, the share at which |dot| of their direction and direction_at(middle) is at least `least`.
template <typename DirectionAt>
double share_along(const std::vector<Piece>& all, double least, const DirectionAt& direction_at) {
    double along = 0.0, total = 0.0;
    for (const Piece& piece : all) {
        if (!(piece.length() > 0.0)) continue;
        total += piece.length();
        const dvec3 way = (piece.to - piece.from) / piece.length();
        if (std::abs(glm::dot(way, direction_at(0.5 * (piece.from + piece.to)))) >= least) along += piece.length();
    }
    return along / total;
}

double distance(const dvec3& p, const Piece& piece) {
    const dvec3 way = piece.to - piece.from;
    const double t = std::clamp(glm::dot(p - piece.from, way) / std::max(glm::dot(way, way), 1e-30), 0.0, 1.0);
    return glm::distance(p, piece.from + t * way);
}

}  // namespace

TEST(BendDirections, GoAroundTubesAndAreLevelOnWhatDoesNotBend) {
    const Surface around(tube(48, 40).name, tube(48, 40).arrays());
    const auto found = bend_directions(around);
    EXPECT_TRUE(found->any);
    for (Index t = 0; t < around.triangles.size(); ++t)
        for (int k = 0; k < 3; ++k) {
            const dvec3 p(around.positions[around.triangles[t][k]]), d(found->corner[t][k]);
            EXPECT_NEAR(std::abs(glm::dot(d, glm::normalize(dvec3(-p.y, p.x, 0)))), 1.0, 1e-3);
        }
    const Mesh cube = box();
    const Surface flat(cube.name, cube.arrays());
    const auto none_found = bend_directions(flat);
    EXPECT_FALSE(none_found->any);
    for (Index t = 0; t < flat.triangles.size(); ++t)
        for (const vec3& d : none_found->corner[t]) {
            EXPECT_NEAR(glm::length(d), 1.0f, 1e-6f);
            EXPECT_NEAR(d.z, 0.0f, 1e-6f);
        }
}

TEST(BendDirections, GoAroundACylinderBetweenItsCaps) {
    // All vertices of the closed one are on folds.
    Mesh mesh = tube(32, 1, 2.0);
    std::vector<int> top, bottom;
    Polygons polygons;
    for (int i = 0; i < 32; ++i) {
        const int k = (i + 1) % 32;
        polygons.push_back({i, k, 32 + k, 32 + i});
        top.push_back(32 + i);
        bottom.push_back(31 - i);
    }
    polygons.push_back(top);
    polygons.push_back(bottom);
    mesh = of_polygons("cylinder", {mesh.positions.begin(), mesh.positions.end()}, polygons);
    const Surface surface(mesh.name, mesh.arrays());
    const auto found = bend_directions(surface);
    EXPECT_TRUE(found->any);
    for (Index t = 0; t < surface.triangles.size(); ++t)
        for (const vec3& d : found->corner[t]) EXPECT_NEAR(d.z, 0.0f, 1e-3f);
}

TEST(BendDirections, OfATorusGoAroundItsTubeHoweverFineItsMeshIs) {
    for (const int n : {24, 96, 480}) {  // the last one has more vertices than are averaged directly
        const Mesh mesh = torus(n / 2, n);
        const Surface surface(mesh.name, mesh.arrays());
        const auto found = bend_directions(surface);
        int wrong = 0;
        for (Index t = 0; t < surface.triangles.size(); ++t)
            for (int k = 0; k < 3; ++k) {
                const dvec3 p(surface.positions[surface.triangles[t][k]]);
                const dvec3 along_ring = glm::normalize(dvec3(-p.y, p.x, 0));
                wrong += std::abs(glm::dot(dvec3(found->corner[t][k]), along_ring)) > 0.1;
            }
        EXPECT_LE(wrong, int(surface.triangles.size()) * 3 / 100) << n;
    }
}

TEST(Streamlines, RunAroundATubeOrAlongItOrBetween) {
    const Mesh mesh = tube(48, 40);
    const Surface surface(mesh.name, mesh.arrays());
    for (const double degrees : {0.0, 90.0, 40.0, -40.0}) {
        const auto all = pieces(surface, degrees, -3);
        EXPECT_GT(all.size(), 1000u);
        const double least = std::cos(glm::radians(4.0));
        EXPECT_GT(share_along(all, least,
                              [&](const dvec3& p) {
                                  const dvec3 around = glm::normalize(dvec3(-p.y, p.x, 0));
                                  const double a = glm::radians(degrees);
                                  return std::cos(a) * around + std::sin(a) * dvec3(0, 0, 1);
                              }),
                  0.99)
            << degrees;
    }
}

TEST(Streamlines, GoOnFromTriangleToTriangleAtTheSamePlaces) {
    const Mesh mesh = torus(30, 70);
    const Surface surface(mesh.name, mesh.arrays());
    const auto all = pieces(surface, 20.0, -4);
    std::map<Index, std::map<std::array<double, 3>, int>> ends;
    std::map<Index, int> count;
    for (const Piece& piece : all) {
        ++count[piece.curve];
        for (const dvec3& p : {piece.from, piece.to}) {
            const vec3 rounded(p);
            ++ends[piece.curve][{rounded.x, rounded.y, rounded.z}];
        }
    }
    std::size_t longest = 0;
    for (const auto& [curve, places] : ends) {
        int open = 0;
        for (const auto& [place, times] : places) open += times == 1;
        EXPECT_LE(open, 2) << curve;
        longest = std::max(longest, std::size_t(count[curve]));
    }
    EXPECT_GT(longest, 100u);
}

TEST(Streamlines, CrossATriangleAtMostOnce) {
    for (const Mesh& mesh : {torus(30, 70), tube(64, 1, 2.0), cylinder(64), sphere(24)}) {
        const Surface surface(mesh.name, mesh.arrays());
        std::set<std::pair<Index, Index>> seen;
        for (const Piece& piece : pieces(surface, 0.0, -4)) {
            EXPECT_TRUE(seen.insert({piece.curve, piece.triangle}).second)
                << piece.from.x << " " << piece.from.y << " " << piece.from.z << "  " << piece.to.x << " " << piece.to.y
                << " " << piece.to.z;
        }
    }
}

TEST(Streamlines, KeepTheirDistanceAndLeaveNoGaps) {
    const Mesh mesh = torus(40, 120);
    const Surface surface(mesh.name, mesh.arrays());
    const int power = -4;
    const double apart = std::ldexp(1.0, power);
    for (const double degrees : {0.0, 90.0}) {
        const auto all = pieces(surface, degrees, power);
        int near = 0, tried = 0, far = 0;
        for (std::size_t i = 0; i < all.size(); i += 7) {
            const dvec3 p = 0.5 * (all[i].from + all[i].to);
            ++tried;
            for (const Piece& other : all)
                if (other.curve != all[i].curve && distance(p, other) < 0.4 * apart) {
                    ++near;
                    break;
                }
        }
        EXPECT_LE(near, tried / 100) << degrees;
        int places = 0;
        for (Index t = 0; t < surface.triangles.size(); t += 5) {
            dvec3 p(0.0);
            for (int k = 0; k < 3; ++k) p += dvec3(surface.positions[surface.triangles[t][k]]) / 3.0;
            ++places;
            double least = HUGE_VAL;
            for (const Piece& piece : all) least = std::min(least, distance(p, piece));
            far += least > 1.5 * apart;
        }
        EXPECT_LE(far, places / 100) << degrees;
    }
}

TEST(Streamlines, OfACoarserLevelAreAmongThoseOfAFinerOne) {
    const Mesh mesh = torus(30, 70);
    const Surface surface(mesh.name, mesh.arrays());
    using Key = std::tuple<Index, Index, double, double, double>;
    const auto keys = [&](int power) {
        std::set<Key> found;
        for (const Piece& piece : pieces(surface, 30.0, power))
            found.insert({piece.triangle, piece.curve, piece.from.x, piece.from.y, piece.from.z});
        return found;
    };
    const auto coarse = keys(-2), fine = keys(-4);
    EXPECT_GT(coarse.size(), 100u);
    EXPECT_GT(fine.size(), 2 * coarse.size());
    for (const Key& key : coarse) EXPECT_TRUE(fine.contains(key));
}

TEST(Streamlines, StayWhereTheyAreOnASurfaceThatDeforms) {
    const Mesh mesh = torus(30, 70);
    Surface still(mesh.name, mesh.arrays()), moving(mesh.name, mesh.arrays());
    moving.set_rest(mesh.positions);
    std::vector<vec3> positions(mesh.positions);
    for (vec3& p : positions) p = vec3(p.x + 0.3f * p.z * p.z, 1.4f * p.y, p.z + 0.5f * p.x);
    moving.set_positions(positions);
    const std::array angles{0.3};
    const auto a = streamlines(still, angles, -3).front(), b = streamlines(moving, angles, -3).front();
    ASSERT_GT(a->values.size(), 500u);
    ASSERT_EQ(a->values.size(), b->values.size());
    for (std::size_t i = 0; i < a->values.size(); ++i)
        for (const int k : {0, 1}) EXPECT_EQ(a->values[i].weight[k], b->values[i].weight[k]);
}

TEST(Streamlines, OfSeveralAnglesAreThoseOfEachAlone) {
    const Mesh mesh = torus(30, 70);
    const Surface surface(mesh.name, mesh.arrays());
    const std::array angles{0.3, 1.3, 0.8};
    const auto together = streamlines(surface, angles, -4);
    ASSERT_EQ(together.size(), angles.size());
    for (std::size_t i = 0; i < angles.size(); ++i) {
        const Surface another(mesh.name, mesh.arrays());
        const Streamlines &a = *together[i], &b = *streamlines(another, std::array{angles[i]}, -4).front();
        ASSERT_GT(a.values.size(), 1000u);
        ASSERT_EQ(a.values.size(), b.values.size());
        EXPECT_EQ(a.offsets, b.offsets);
        for (std::size_t k = 0; k < a.values.size(); ++k) {
            EXPECT_EQ(a.values[k].curve, b.values[k].curve);
            EXPECT_EQ(a.values[k].weight[0], b.values[k].weight[0]);
        }
    }
}

TEST(Streamlines, OfAnAngleThatIsInUseAreNotGrownAgain) {
    const Mesh mesh = torus(12, 30);
    const Surface surface(mesh.name, mesh.arrays());
    const auto first = streamlines(surface, std::array{0.3, 1.3}, -3);
    for (int k = 0; k < 20; ++k) {
        const auto then = streamlines(surface, std::array{0.3, 1.4 + 0.01 * k}, -3);
        EXPECT_EQ(then[0], first[0]) << k;
        EXPECT_NE(then[1], first[1]) << k;
    }
}

TEST(Streamlines, EndWhereAVertexWasFlungAway) {
    Mesh mesh = torus(12, 20);
    mesh.positions[7] = vec3(1e35f, 2e35f, -1e35f);
    const Surface surface(mesh.name, mesh.arrays());
    const auto lines = streamlines(surface, std::array{0.3}, -4).front();
    EXPECT_EQ(lines->count(), surface.triangles.size());
}

TEST(Streamlines, EndAtFolds) {
    const Mesh mesh = box();
    const Surface surface(mesh.name, mesh.arrays());
    const auto all = pieces(surface, 0.0, -4);
    std::map<Index, std::set<Index>> facets;
    for (const Piece& piece : all) facets[piece.curve].insert(surface.triangle_facet[piece.triangle]);
    EXPECT_GT(facets.size(), 6u * 20u);
    for (const auto& [curve, on] : facets) EXPECT_EQ(on.size(), 1u);
}

TEST(Streamlines, OfAHugeSurfaceAreNotMoreThanTheirBound) {
    const Mesh mesh = tube(48, 40);
    const Surface surface(mesh.name, mesh.arrays());
    const auto bounded = streamlines(surface, std::array{0.0}, -1000).front();
    EXPECT_GT(bounded->values.size(), 10'000u);
    EXPECT_LT(bounded->values.size(), 2'000'000u);
}
