// SPDX-License-Identifier: GPL-3.0-or-later
// Limit surfaces of cages: known limit points, closed forms of B-splines, and what the refined mesh keeps of the cage.
#include <gtest/gtest.h>
#include <random>

#include <fovea/field/exact_curvature.h>
#include <fovea/field/fields.h>
#include <fovea/field/jets.h>
#include <fovea/mesh/refine.h>

#include "analytic.h"
#include "field_errors.h"

using namespace fovea;
using namespace fovea::draw;
using namespace fovea::meshes;

namespace {

RefinedSurface refined(const Mesh& cage, int level, std::vector<float> creases = {}, bool round_corners = false) {
    return RefinedSurface(cage.name, cage.arrays(),
                          {.level = level, .round_corners = round_corners, .edge_crease = creases});
}

/// The distance from a point to the nearest vertex.
float distance_to(const Surface& surface, const vec3& point) {
    float least = 1e30f;
    for (Index v = 0; v < surface.vertex_count(); ++v)
        least = std::min(least, glm::distance(surface.positions[v], point));
    return least;
}

float farthest(const Surface& surface) {
    float most = 0.0f;
    for (Index v = 0; v < surface.vertex_count(); ++v) most = std::max(most, glm::length(surface.positions[v]));
    return most;
}

std::string message_of(const Mesh& cage) {
    try {
        refined(cage, 1);
    } catch (const std::invalid_argument& error) {
        return error.what();
    }
    return "";
}

/// n x m quads around a torus.
Mesh torus_cage(int n, int m, double R = 1.0, double r = 0.4) {
    Mesh cage("torus", {});
    for (int j = 0; j < m; ++j)
        for (int i = 0; i < n; ++i) {
            const double a = 2 * std::numbers::pi * i / n, b = 2 * std::numbers::pi * j / m, d = R + r * std::cos(b);
            cage.positions.push_back(vec3(dvec3(d * std::cos(a), d * std::sin(a), r * std::sin(b))));
        }
    for (int j = 0; j < m; ++j)
        for (int i = 0; i < n; ++i) {
            const int k = (i + 1) % n, l = (j + 1) % m;
            cage.add_polygon({i + n * j, k + n * j, k + n * l, i + n * l});
        }
    return cage;
}

/// A flat pentagon with a triangle at each side.
Mesh flower() {
    Mesh mesh("flower", {});
    for (int i = 0; i < 10; ++i) {
        const double a = std::numbers::pi * (i % 5 + (i < 5 ? 0.0 : 0.5)) / 2.5, r = i < 5 ? 1.0 : 1.5;
        mesh.positions.push_back(vec3(dvec3(r * std::cos(a), r * std::sin(a), 0)));
    }
    mesh.add_polygon({0, 1, 2, 3, 4});
    for (int i = 0; i < 5; ++i) mesh.add_polygon({(i + 1) % 5, i, 5 + i});
    return mesh;
}

/// A height field over n x n unit squares around the origin with random heights.
Mesh rough_field(int n) {
    Mesh cage = grid(n, 0.5f * float(n));
    std::mt19937 random(7);
    std::uniform_real_distribution<float> height(-0.5f, 0.5f);
    for (vec3& p : cage.positions) p.z = height(random);
    return cage;
}

/// Uniform cubic B-spline: derivative `d` at t in [0,1] of the piece with four control values, as their weights.
std::array<double, 4> b_spline(double t, int d) {
    const double c[4][4] = {{1, -3, 3, -1}, {4, 0, -6, 3}, {1, 3, 3, -3}, {0, 0, 0, 1}};
    std::array<double, 4> w;
    for (int i = 0; i < 4; ++i) {
        const double* a = c[i];
        w[i] = (d == 0   ? a[0] + t * (a[1] + t * (a[2] + t * a[3]))
                : d == 1 ? a[1] + t * (2 * a[2] + t * 3 * a[3])
                : d == 2 ? 2 * a[2] + t * 6 * a[3]
                         : 6 * a[3]) /
               6.0;
    }
    return w;
}

/// d^(a+b) z / dx^a dy^b of the B-spline over `rough_field(n)`; at knots the mean of the pieces that meet.
double b_spline_height(const Mesh& cage, int n, double x, double y, int a, int b) {
    double sum = 0.0;
    int pieces = 0;
    for (double dx : {-1e-9, 1e-9})
        for (double dy : {-1e-9, 1e-9}) {
            const int i = int(std::floor(x + dx + 0.5 * n)), j = int(std::floor(y + dy + 0.5 * n));
            const auto u = b_spline(x + 0.5 * n - i, a), v = b_spline(y + 0.5 * n - j, b);
            for (int k = 0; k < 4; ++k)
                for (int l = 0; l < 4; ++l) sum += u[k] * v[l] * cage.positions[i - 1 + k + (n + 1) * (j - 1 + l)].z;
            ++pieces;
        }
    return sum / pieces;
}

}  // namespace

TEST(Refine, CornersOfACube) {
    // (n^2 v + 4 sum of edge neighbors + sum of diagonal ones) / (n (n + 5)) with n = 3.
    for (int level : {1, 2, 4}) {
        const RefinedSurface surface = refined(box(), level);
        EXPECT_EQ(surface.polygon_count(), 6u << (2 * level));
        EXPECT_LT(distance_to(surface, vec3(0.5f)), 1e-6f);
        EXPECT_NEAR(farthest(surface), std::sqrt(0.75f), 1e-6f);
    }
}

TEST(Refine, APlanarCageIsFlat) {
    const RefinedSurface surface = refined(flower(), 3);
    ASSERT_EQ(surface.jets.size(), surface.vertex_count());
    for (Index v = 0; v < surface.vertex_count(); ++v) {
        EXPECT_EQ(surface.positions[v].z, 0.0f);
        EXPECT_NEAR(glm::distance(surface.jets[v].normal, vec3(0, 0, 1)), 0.0f, 1e-6f);
        for (float second : surface.jets[v].second) EXPECT_NEAR(second, 0.0f, 1e-6f);
        for (float third : surface.jets[v].third) EXPECT_NEAR(third, 0.0f, 1e-6f);
    }
    EXPECT_EQ(surface.facet_count(), surface.polygon_count());
}

TEST(Refine, ARegularPatchIsABSpline) {
    const int n = 6;
    const Mesh cage = rough_field(n);
    const RefinedSurface surface = refined(cage, 2);
    int seen = 0;
    for (Index v = 0; v < surface.vertex_count(); ++v) {
        const vec3 p = surface.positions[v];
        if (std::max(std::abs(p.x), std::abs(p.y)) > 0.5f * n - 1.1f) continue;
        ++seen;
        const double x = std::round(4 * p.x) / 4, y = std::round(4 * p.y) / 4;
        const auto z = [&](int a, int b) { return b_spline_height(cage, n, x, y, a, b); };
        EXPECT_NEAR(glm::distance(p, vec3(x, y, z(0, 0))), 0.0f, 1e-6f);
        ImplicitJet jet;
        jet.gradient = {-z(1, 0), -z(0, 1), 1};
        jet.hessian = -dmat3(z(2, 0), z(1, 1), 0, z(1, 1), z(0, 2), 0, 0, 0, 0);
        jet.third[0] = -dmat3(z(3, 0), z(2, 1), 0, z(2, 1), z(1, 2), 0, 0, 0, 0);
        jet.third[1] = -dmat3(z(2, 1), z(1, 2), 0, z(1, 2), z(0, 3), 0, 0, 0, 0);
        const CurvatureD exact = curvature_of(jet);
        const Curvature found = fields_of(surface)->curvature[v];
        EXPECT_NEAR(glm::distance(dvec3(found.normal), exact.normal), 0.0, 1e-6);
        EXPECT_NEAR(found.k1, exact.k1, 2e-6);
        EXPECT_NEAR(found.k2, exact.k2, 2e-6);
        double third[4];
        analytic::in_frame(found, exact.e1, exact.e2, third);
        for (int i = 0; i < 4; ++i) EXPECT_NEAR(third[i], exact.C[i], 1e-5) << x << " " << y;
    }
    EXPECT_EQ(seen, 15 * 15);
}

TEST(Refine, NormalsTurnAsTheCurvatureSays) {
    // h(d, d) along every edge: the difference of the normals over the length, to second order.
    const RefinedSurface surface = refined(torus_cage(10, 8), 4);
    const auto fields = fields_of(surface);
    double worst = 0.0;
    for (Index e = 0; e < surface.mesh_edges; ++e) {
        const Edge edge = surface.edges[e];
        const Curvature &a = fields->curvature[edge.x], &b = fields->curvature[edge.y];
        EXPECT_NEAR(glm::length(a.normal), 1.0f, 1e-6f);
        const dvec3 d(surface.positions[edge.y] - surface.positions[edge.x]);
        const auto h = [&](const Curvature& c) {
            return c.k1 * std::pow(glm::dot(dvec3(c.e1), d), 2) + c.k2 * std::pow(glm::dot(dvec3(c.e2), d), 2);
        };
        const double turned = glm::dot(dvec3(b.normal - a.normal), d);
        worst = std::max(worst, std::abs(turned - 0.5 * (h(a) + h(b))) / glm::dot(d, d));
    }
    EXPECT_LT(worst, 0.01);  // of curvatures up to 3
}

TEST(Refine, JetsFittedToADenseMeshAgree) {
    const RefinedSurface surface = refined(torus_cage(12, 8), 5);
    const Array<Curvature> fitted =
        fields_of(surface, {.estimator = Estimator::jets, .degree = 4, .rings = 3})->curvature;
    const Array<Curvature> exact = fields_of(surface)->curvature;
    std::vector<double> k, c;
    double squares = 0.0;
    for (Index v = 0; v < surface.vertex_count(); ++v) {
        k.push_back(std::abs(fitted[v].k1 - exact[v].k1) / std::abs(exact[v].k1));
        double third[4];
        analytic::in_frame(fitted[v], dvec3(exact[v].e1), dvec3(exact[v].e2), third);
        for (int i = 0; i < 4; ++i) third[i] -= exact[v].C[i];
        c.push_back(analytic::norm(third));
        squares += std::pow(analytic::norm(exact[v].C), 2);
    }
    std::sort(k.begin(), k.end());
    std::sort(c.begin(), c.end());
    EXPECT_LT(k[k.size() / 2], 5e-4);
    EXPECT_LT(k[k.size() * 99 / 100], 5e-3);
    EXPECT_LT(c[c.size() / 2] / std::sqrt(squares / double(c.size())), 0.02);
}

TEST(Refine, InfinitelySharpEdgesStay) {
    const Mesh cage = box();
    const RefinedSurface surface = refined(cage, 3, std::vector<float>(12, 1.0f));
    int right_angles = 0;
    for (Index v = 0; v < surface.vertex_count(); ++v) {
        const vec3 p = glm::abs(surface.positions[v]);
        EXPECT_NEAR(std::max({p.x, p.y, p.z}), 1.0f, 1e-6f);
        for (float second : surface.jets[v].second) EXPECT_NEAR(second, 0.0f, 1e-5f);
    }
    for (Index e = 0; e < surface.mesh_edges; ++e) {
        const Index begin = surface.edge_rows.begin(e);
        const vec4 a = surface.facet_plane[surface.edge_sides[begin].facet()];
        const vec4 b = surface.facet_plane[surface.edge_sides[begin + 1].facet()];
        right_angles += std::abs(glm::dot(vec3(a), vec3(b))) < 1e-3f;
    }
    EXPECT_EQ(right_angles, 12 * 8);
}

TEST(Refine, ASharpRingIsACubicBSpline) {
    Mesh cage = box();
    std::vector<float> creases(12, 0.0f);
    for (auto [a, b] : {std::pair{4, 5}, {5, 7}, {7, 6}, {6, 4}}) creases[cage.edge(a, b)] = 1.0f;
    const RefinedSurface surface = refined(cage, 3, creases);
    EXPECT_LT(distance_to(surface, vec3(2.0f / 3.0f, 2.0f / 3.0f, 1.0f)), 1e-6f);  // (1 4 1) / 6 at a corner
    EXPECT_LT(distance_to(surface, vec3(11.0f / 12.0f, 0.0f, 1.0f)), 1e-6f);       // (1 23 23 1) / 48 between two
    // Jets at the ring are of one side: above it is flat, below it is round.
    for (Index v = 0; v < surface.vertex_count(); ++v)
        if (surface.positions[v].z > 1.0f - 1e-6f) {
            const float up = surface.jets[v].normal.z;
            EXPECT_TRUE(up > 1.0f - 1e-5f || up < 0.9f) << up;
        }
}

TEST(Refine, SemiSharpEdgesLieBetween) {
    const auto corner = [](float sharpness) {
        return farthest(refined(box(), 2, std::vector<float>(12, std::sqrt(0.1f * sharpness)))) / std::sqrt(3.0f);
    };
    EXPECT_NEAR(corner(0.0f), 0.5f, 1e-6f);
    // One sharp step and then smooth ones: the mask above on the corner of a cube of 2 x 2 x 2.
    EXPECT_NEAR(corner(1.0f), 0.75f, 1e-6f);
    EXPECT_NEAR(corner(2.0f), 0.875f, 1e-6f);
    EXPECT_NEAR(corner(10.0f), 1.0f, 1e-6f);
    float before = 0.0f;
    for (float s : {0.3f, 0.7f, 1.4f, 2.6f, 4.5f, 7.0f}) {
        EXPECT_GT(corner(s), before);
        before = corner(s);
    }
}

TEST(Refine, VertexCreases) {
    const Mesh cage = box();
    std::vector<float> creases(8, 0.0f);
    creases[7] = 1.0f;
    const RefinedSurface surface("box", cage.arrays(), {.level = 3, .vertex_crease = creases});
    EXPECT_LT(distance_to(surface, vec3(1.0f)), 1e-6f);
    EXPECT_GT(distance_to(surface, vec3(-1.0f)), 0.5f);
}

TEST(Refine, CornersOfABorder) {
    EXPECT_LT(distance_to(refined(grid(4), 2), vec3(1, 1, 0)), 1e-6f);
    const RefinedSurface rounded = refined(grid(4), 2, {}, true);
    const float at = 1.0f - 0.5f / 6.0f;  // the border alone: (1 4 1) / 6
    EXPECT_LT(distance_to(rounded, vec3(at, at, 0)), 1e-6f);
}

TEST(Refine, TrianglesAndPolygonsOfManyCorners) {
    Mesh prism("prism", {});
    for (float z : {-1.0f, 1.0f})
        for (int i = 0; i < 5; ++i) {
            const double a = 2 * std::numbers::pi * i / 5;
            prism.positions.push_back(vec3(dvec3(std::cos(a), std::sin(a), z)));
        }
    prism.add_polygon({4, 3, 2, 1, 0});
    prism.add_polygon({5, 6, 7, 8, 9});
    for (int i = 0; i < 5; ++i) prism.add_polygon({i, (i + 1) % 5, 5 + (i + 1) % 5, 5 + i});
    for (const Mesh& cage : {tetrahedron(), prism, sphere(5)})
        for (int level : {1, 2, 3}) {
            const RefinedSurface surface = refined(cage, level);
            EXPECT_EQ(surface.polygon_count() >> (2 * (level - 1)), cage.corner_verts.size());
            EXPECT_EQ(surface.report().degenerate_polygons + surface.report().inconsistent_edges, 0u);
            double most = 0.0;
            for (Index v = 0; v < surface.vertex_count(); ++v) {
                EXPECT_NEAR(glm::length(surface.jets[v].normal), 1.0f, 1e-6f);
                EXPECT_GT(glm::dot(surface.jets[v].normal, surface.positions[v]), 0.0f);
                for (float second : surface.jets[v].second) most = std::max(most, double(std::abs(second)));
            }
            EXPECT_LT(most, 12.0);
        }
}

TEST(Refine, NormalsAreThoseOfTheFacetsWhereverFourQuadsDoNotMeet) {
    for (const Mesh& cage : {box(), tetrahedron(), sphere(4)}) {
        const RefinedSurface surface = refined(cage, 5);
        const auto neighbors = neighbors_of(surface);
        for (Index v = 0; v < surface.vertex_count(); ++v)
            for (const Index t : neighbors->triangles[v]) {
                const vec4 plane = surface.facet_plane[surface.triangle_facet[t]];
                EXPECT_GT(glm::dot(vec3(plane), surface.jets[v].normal), 0.99f);
            }
    }
}

TEST(Refine, MarksAndMaterialsGoOn) {
    Mesh cage = box();
    cage.material = {0, 1, 2, 3, 4, 5};
    cage.sharp = cage.edge_flags({0});
    cage.seam = cage.edge_flags({1, 2});
    cage.edge_mark = cage.edge_flags({3});
    const RefinedSurface surface = refined(cage, 2);
    std::array<int, 6> materials{};
    for (int m : surface.polygon_material) ++materials[m];
    for (int count : materials) EXPECT_EQ(count, 16);
    std::array<int, 3> marks{};
    for (std::uint8_t m : surface.edge_marks)
        for (int bit = 0; bit < 3; ++bit) marks[bit] += (m >> bit) & 1;
    EXPECT_EQ(marks, (std::array<int, 3>{4, 8, 4}));
    // The first polygon faces down, and so do the quads that descend from it.
    for (Index f = 0; f < surface.facet_count(); ++f)
        if (surface.polygon_material[surface.facet_polygon[f]] == 0) {
            EXPECT_LT(surface.facet_plane[f].z, 0.0f);
        }
}

TEST(Refine, LooseVerticesAndEdgesAreLeftOut) {
    Mesh cage = box();
    cage.positions.insert(cage.positions.end(), {vec3(9), vec3(10)});
    cage.edge(8, 9);
    cage.edge(0, 8);
    EXPECT_NEAR(farthest(refined(cage, 2)), std::sqrt(0.75f), 1e-6f);
}

TEST(Refine, AMovedCageIsTheSameAsANewOne) {
    Mesh cage = tetrahedron();
    RefinedSurface moved = refined(cage, 3);
    const auto before = fields_of(moved);
    for (vec3& p : cage.positions) p = vec3(1.5f * p.x + 0.2f * p.y, p.y - 0.1f * p.z * p.z, 0.7f * p.z);
    moved.move_cage(cage.positions);
    const RefinedSurface fresh = refined(cage, 3);
    EXPECT_EQ(moved.positions, fresh.positions);
    const auto a = fields_of(moved), b = fields_of(fresh);
    EXPECT_NE(a, before);
    for (Index v = 0; v < fresh.vertex_count(); ++v) {
        EXPECT_EQ(a->curvature[v].k1, b->curvature[v].k1);
        EXPECT_EQ(a->curvature[v].C[0], b->curvature[v].C[0]);
    }
    EXPECT_THROW(moved.move_cage({}), std::invalid_argument);
}

TEST(Refine, AtRestVerticesLieOnTheLimitOfTheCageAtRest) {
    Mesh cage = tetrahedron();
    const std::vector<vec3> at_rest = cage.positions;
    const RefinedSurface before = refined(cage, 2);
    for (vec3& p : cage.positions) p *= 1.0f + p.x;
    RefinedSurface deformed = refined(cage, 2);
    deformed.set_cage_rest(at_rest);
    EXPECT_TRUE(std::ranges::equal(deformed.rest(), In<vec3>(before.positions).first(before.vertex_count())));
    const RefinedSurface fresh = refined(cage, 2);
    EXPECT_EQ(deformed.positions, fresh.positions);
    EXPECT_EQ(fields_of(deformed)->curvature[0].k1, fields_of(fresh)->curvature[0].k1);
    deformed.move_cage(at_rest);
    EXPECT_EQ(deformed.positions, before.positions);
    deformed.set_cage_rest({});
    EXPECT_TRUE(deformed.rest().empty());
    EXPECT_THROW(deformed.set_cage_rest(std::vector<vec3>(3)), std::invalid_argument);
}

TEST(Refine, CagesWithoutALimitSurface) {
    EXPECT_NE(message_of(two_boxes_at_an_edge()).find("two boxes: 1 edges lie between more than"), std::string::npos);
    EXPECT_NE(message_of(flipped(box(), [](int f) { return f == 0; })).find("disagree"), std::string::npos);
    EXPECT_NE(message_of(moebius(8)).find("disagree"), std::string::npos);
    Mesh touching = box();
    touching.positions.insert(touching.positions.end(), {{2, 2, 3}, {3, 2, 2}, {2, 3, 2}});
    for (const auto& t : Polygons{{7, 9, 8}, {7, 10, 9}, {7, 8, 10}, {8, 9, 10}}) touching.add_polygon(t);
    EXPECT_NE(message_of(touching).find("in 1 vertices surfaces only touch"), std::string::npos);
    Mesh twice("twice", {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}});
    twice.add_polygon({0, 1, 2, 1});
    EXPECT_NE(message_of(twice).find("a vertex twice"), std::string::npos);
    EXPECT_THROW(refined(box(), 0), std::invalid_argument);
    EXPECT_THROW(refined(box(), 8), std::invalid_argument);
}

TEST(Refine, FieldsSayWhereTheyComeFrom) {
    const RefinedSurface surface = refined(torus_cage(8, 6), 2);
    EXPECT_EQ(fields_of(surface)->reason.substr(0, 5), "exact");
    EXPECT_NE(fields_of(surface, {.estimator = Estimator::jets})->reason.find("jets"), std::string::npos);
    EXPECT_NE(fields_of(*torus_cage(8, 6).surface())->reason.find("jets"), std::string::npos);
}
