// SPDX-License-Identifier: GPL-3.0-or-later
// Curvature under what must not change it, on broken input, and at hard edges.
#include <algorithm>
#include <cmath>
#include <cstring>
#include <gtest/gtest.h>
#include <limits>
#include <numeric>
#include <tbb/global_control.h>
#include <utility>
#include <vector>

#include <fovea/field/fields.h>
#include <fovea/field/normals.h>
#include <fovea/mesh/stretch.h>

#include "field_errors.h"

using namespace fovea;
using namespace fovea::draw;
using namespace fovea::analytic;

namespace {

using Estimate = Array<Curvature> (*)(const Surface&);
Array<Curvature> jets(const Surface& surface) {
    return fields_of(surface, {.estimator = Estimator::jets, .degree = 4, .rings = 3})->curvature;
}
Array<Curvature> one_rings(const Surface& surface) {
    return fields_of(surface, {.estimator = Estimator::one_ring})->curvature;
}
const Estimate estimates[] = {jets, one_rings};

bool finite(const Curvature& c) {
    float sum = c.k1 + c.k2 + c.C[0] + c.C[1] + c.C[2] + c.C[3];
    for (int i = 0; i < 3; ++i) sum += c.normal[i] + c.e1[i] + c.e2[i];
    return std::isfinite(sum);
}

/// A box of n x n quads on each side, vertices shared.
Mesh fine_box(int n) {
    Mesh mesh("fine box", {});
    std::map<std::array<int, 3>, int> number;
    const auto at = [&](std::array<int, 3> p) {
        const auto [it, added] = number.try_emplace(p, int(mesh.positions.size()));
        if (added) mesh.positions.push_back(vec3(p[0], p[1], p[2]) / float(n));
        return it->second;
    };
    for (int axis = 0; axis < 3; ++axis)
        for (int side : {0, n})
            for (int i = 0; i < n; ++i)
                for (int j = 0; j < n; ++j) {
                    const auto corner = [&](int di, int dj) {
                        std::array<int, 3> p;
                        p[axis] = side, p[(axis + 1) % 3] = i + di, p[(axis + 2) % 3] = j + dj;
                        return at(p);
                    };
                    std::vector<int> quad{corner(0, 0), corner(1, 0), corner(1, 1), corner(0, 1)};
                    if (side == 0) std::reverse(quad.begin(), quad.end());
                    mesh.add_polygon(quad);
                }
    return mesh;
}

}  // namespace

TEST(FieldSizes, AreOfTheCurvatureBelowWhichATenthOfTheAreaIs) {
    const Sample samples[] = {ellipsoid(4, true, dvec3(3.0, 2.0, 1.0)), ellipsoid(2, true, dvec3(0.3)),
                              torus({.n = 200})};
    for (const Sample& sample : samples) {
        const auto surface = sample.mesh.surface();
        const auto fields = fields_of(*surface);
        const Array<float> areas = vertex_areas(*surface, *neighbors_of(*surface));
        std::vector<std::pair<float, double>> sorted;
        double all = 0.0;
        for (Index v = 0; v < surface->vertex_count(); ++v)
            for (const float k : {fields->curvature[v].k1, fields->curvature[v].k2}) {
                sorted.emplace_back(std::abs(k), areas[v]);
                all += areas[v];
            }
        std::ranges::sort(sorted);
        std::size_t i = 0;
        for (double below = sorted[0].second; below <= 0.1 * all; below += sorted[++i].second) continue;
        ASSERT_LT(0.01 / sorted[i].first, greatest_feature_size(*surface));
        EXPECT_EQ(fields->feature_size, static_cast<float>(0.01 / sorted[i].first));
    }
}

TEST(FieldConditions, SphereIsRoundEverywhere) {
    Mesh mesh = meshes::sphere(48);
    for (vec3& p : mesh.positions) p *= 2.0f;
    const auto surface = mesh.surface();
    for (const Curvature& c : jets(*surface)) {
        EXPECT_NEAR(c.k1, 0.5f, 2e-3f);
        EXPECT_NEAR(c.k2, 0.5f, 2e-3f);
        for (float third : c.C) EXPECT_NEAR(third, 0.0f, 2e-2f);
    }
}

TEST(FieldConditions, FramesAreRightHandedAndOrdered) {
    const auto surface = waves({.n = 24, .irregular = true}).mesh.surface();
    for (const Estimate estimate : estimates)
        for (const Curvature& c : estimate(*surface)) {
            EXPECT_NEAR(glm::distance(glm::cross(c.e1, c.e2), c.normal), 0.0f, 1e-5f);
            EXPECT_GE(std::abs(c.k1), std::abs(c.k2));
        }
}

TEST(FieldConditions, ThreadsAndScaleAndRotation) {
    const Sample sample = torus({.n = 32, .irregular = true});
    const auto surface = sample.mesh.surface();
    Mesh turned = sample.mesh;
    const double angle = 0.7;
    const dmat3 turn(std::cos(angle), 0, -std::sin(angle), 0, 1, 0, std::sin(angle), 0, std::cos(angle));
    for (vec3& p : turned.positions) p = vec3(8.0 * (turn * dvec3(p)));
    const auto other = turned.surface();
    for (const Estimate estimate : estimates) {
        const Array<Curvature> all = estimate(*surface), large = estimate(*other);
        {
            tbb::global_control one(tbb::global_control::max_allowed_parallelism, 1);
            const Array<Curvature> alone = estimate(*sample.mesh.surface());
            EXPECT_EQ(std::memcmp(alone.data(), all.data(), all.size() * sizeof(Curvature)), 0);
        }
        for (std::size_t v = 0; v < all.size(); ++v) {
            EXPECT_NEAR(8.0f * large[v].k1, all[v].k1, 1e-3f * std::abs(all[v].k1));
            EXPECT_NEAR(8.0f * large[v].k2, all[v].k2, 1e-3f * std::abs(all[v].k1));
            const double c = norm(all[v].C);
            EXPECT_NEAR(64.0 * norm(large[v].C), c, 2e-3 * (c + 10.0));
            EXPECT_NEAR(glm::distance(dvec3(large[v].normal), turn * dvec3(all[v].normal)), 0.0, 1e-5);
        }
    }
}

TEST(FieldConditions, OrderOfVerticesAndFacesAndPlace) {
    const Mesh mesh = ellipsoid(3, true).mesh;
    std::mt19937 random(11);
    std::vector<int> number(mesh.positions.size()), order(mesh.polygon_offsets.size() - 1);
    for (auto* shuffled : {&number, &order}) {
        std::iota(shuffled->begin(), shuffled->end(), 0);
        std::shuffle(shuffled->begin(), shuffled->end(), random);
    }
    Mesh other("other", std::vector<vec3>(number.size()));
    for (std::size_t v = 0; v < number.size(); ++v) other.positions[number[v]] = mesh.positions[v] + vec3(2, -1, 4);
    for (int f : order) {
        const int* v = mesh.corner_verts.data() + mesh.polygon_offsets[f];
        other.add_polygon({number[v[1]], number[v[2]], number[v[0]]});
    }
    const auto here = mesh.surface(), there = other.surface();
    const FieldOptions asked[] = {{.estimator = Estimator::jets, .degree = 3, .rings = 2},
                                  {.estimator = Estimator::one_ring},
                                  {.estimator = Estimator::one_ring, .smoothing = 1.0}};
    for (const FieldOptions& options : asked) {
        const auto a = fields_of(*here, options), b = fields_of(*there, options);
        EXPECT_NEAR(a->feature_size, b->feature_size, 1e-3f * a->feature_size);
        for (std::size_t v = 0; v < number.size(); ++v) {
            const Curvature &p = a->curvature[v], &q = b->curvature[number[v]];
            EXPECT_LT(glm::distance(p.normal, q.normal), 1e-4f);
            EXPECT_NEAR(p.k1, q.k1, 2e-3f * std::abs(p.k1));
            EXPECT_NEAR(p.k2, q.k2, 2e-3f * std::abs(p.k1));
            double third[4];
            in_frame(q, dvec3(p.e1), dvec3(p.e2), third);
            for (int i = 0; i < 4; ++i) EXPECT_NEAR(third[i], p.C[i], 0.02 * (norm(p.C) + 1.0));
        }
    }
}

TEST(FieldConditions, BoxIsFlatUpToItsEdges) {
    const auto surface = fine_box(8).surface();
    for (const Estimate estimate : estimates)
        for (const Curvature& c : estimate(*surface)) {
            EXPECT_NEAR(c.k1, 0.0f, 1e-4f);
            EXPECT_NEAR(glm::length(c.normal), 1.0f, 1e-5f);
            for (float third : c.C) EXPECT_NEAR(third, 0.0f, 1e-3f);
        }
}

TEST(FieldConditions, AFoldIsHardWhereTheSurfaceBesideItIsSmooth) {
    const auto hard_vertices = [](const Mesh& mesh) {
        const auto surface = mesh.surface();
        const auto neighbors = neighbors_of(*surface);
        return std::count(neighbors->hard.begin(), neighbors->hard.end(), 1);
    };
    Mesh sheet = meshes::grid(8);
    for (vec3& p : sheet.positions)
        if (p.x > 0.0f) p = {p.x * std::cos(0.9f), p.y, -p.x * std::sin(0.9f)};  // by 52 degrees along its middle
    EXPECT_EQ(hard_vertices(sheet), 9);

    // An icosahedron turns by 42 degrees at each edge: few triangles of something round.
    const float g = 1.618034f;
    Mesh icosahedron("icosahedron", {{0, 1, g},
                                     {0, 1, -g},
                                     {0, -1, g},
                                     {0, -1, -g},
                                     {1, g, 0},
                                     {1, -g, 0},
                                     {-1, g, 0},
                                     {-1, -g, 0},
                                     {g, 0, 1},
                                     {g, 0, -1},
                                     {-g, 0, 1},
                                     {-g, 0, -1}});
    const auto& p = icosahedron.positions;
    const auto near = [&](int i, int j) { return glm::distance(p[i], p[j]) < 2.1f; };
    for (int i = 0; i < 12; ++i)
        for (int j = i + 1; j < 12; ++j)
            for (int k = j + 1; k < 12; ++k) {
                if (!near(i, j) || !near(j, k) || !near(k, i)) continue;
                const bool outward = glm::dot(glm::cross(p[j] - p[i], p[k] - p[i]), p[i]) > 0.0f;
                icosahedron.add_polygon(outward ? std::vector{i, j, k} : std::vector{i, k, j});
            }
    ASSERT_EQ(icosahedron.surface()->triangles.size(), 20u);
    EXPECT_EQ(hard_vertices(icosahedron), 0);
}

TEST(FieldConditions, BrokenInputGivesFiniteValues) {
    Mesh broken = meshes::grid(4);
    broken.positions[7] = vec3(std::numeric_limits<float>::quiet_NaN());
    const Mesh sliver =
        meshes::of_polygons("sliver", {{0, 0, 0}, {1, 0, 0}, {0.5f, 1e-7f, 0}, {0.5f, 1, 0}}, {{0, 1, 2}, {0, 2, 3}});
    const Mesh triangle = meshes::of_polygons("triangle", {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}});
    for (const Mesh& mesh : {broken, sliver, triangle, Mesh("nothing", {}), meshes::two_boxes_at_an_edge(),
                             meshes::moebius(8), meshes::cylinder(6), meshes::box(), meshes::grid(1)}) {
        const auto surface = mesh.surface();
        for (const Estimate estimate : estimates)
            for (const Curvature& c : estimate(*surface)) EXPECT_TRUE(finite(c)) << mesh.name;
        EXPECT_TRUE(std::isfinite(fields_of(*surface)->feature_size)) << mesh.name;
        const auto placed = as_placed(surface, dmat4(dmat3(1, 0, 0, .5, 1, 0, 0, 0, .3)));
        const auto fields = fields_of(*placed, {.smoothing = 2.0});
        for (const Curvature& c : fields->curvature) EXPECT_TRUE(finite(c)) << mesh.name << ", smoothed and sheared";
        EXPECT_TRUE(std::isfinite(fields->feature_size)) << mesh.name;
    }
}

TEST(FieldConditions, AutomaticChoiceFollowsTheNoise) {
    Sample sample = torus({.n = 64});
    const auto clean = fields_of(*sample.mesh.surface());
    EXPECT_NE(clean->reason.find("clean"), std::string::npos) << clean->reason;
    std::mt19937 random(3);
    std::normal_distribution<float> offset(0.0f, 0.001f);  // about 1 % of an edge
    for (vec3& p : sample.mesh.positions) p += offset(random) * vec3(sample.exact(dvec3(p)).normal);
    const auto surface = sample.mesh.surface();
    const auto noisy = fields_of(*surface);
    EXPECT_NE(noisy->reason.find("degree 3, radius 3, smoothed"), std::string::npos) << noisy->reason;
    EXPECT_EQ(noisy, fields_of(*surface)) << "kept";
}
