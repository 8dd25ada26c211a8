// SPDX-License-Identifier: GPL-3.0-or-later
// Clusters of triangles: complete, within their bounds, and never passed over where there is a line.
#include <algorithm>
#include <cstddef>
#include <cstring>
#include <gtest/gtest.h>
#include <limits>
#include <set>

#include <fovea/field/view_curvature.h>
#include <fovea/line/cluster_trace.h>
#include <fovea/line/registry.h>
#include <fovea/line/seen_vertices.h>

#include "analytic.h"
#include "rules.h"

using namespace fovea;
using namespace fovea::draw;
using namespace fovea::analytic;

namespace {

struct Eye {
    dvec3 at;
    bool orthographic;
};

/// Around, near, far away, inside, on the axis, and as directions.
std::vector<Eye> eyes() {
    std::vector<Eye> all;
    std::mt19937 random(7);
    std::normal_distribution<double> normal;
    for (int i = 0; i < 12; ++i) {
        const dvec3 way = glm::normalize(dvec3(normal(random), normal(random), normal(random)));
        for (const double distance : {0.3, 1.05, 1.7, 6.0, 1e4}) all.push_back({distance * way, false});
        all.push_back({way, true});
    }
    for (const dvec3& axis : {dvec3(1, 0, 0), dvec3(0, 0, 1), dvec3(0, 0, -1)}) {
        all.push_back({axis, true});
        all.push_back({3.0 * axis, false});
    }
    all.push_back({dvec3(0), false});
    return all;
}

SurfaceView view_of(const Surface& surface, const Eye& eye) {
    SurfaceView seen{.surface = surface};
    seen.eye_obj = eye.at;
    seen.orthographic = eye.orthographic;
    return seen;
}

Mesh noisy_torus() {
    Mesh mesh = torus({.n = 64, .irregular = true}).mesh;
    std::mt19937 random(3);
    std::normal_distribution<float> offset(0.0f, 0.003f);
    for (vec3& p : mesh.positions) p += vec3(offset(random), offset(random), offset(random));
    return mesh;
}

Mesh with_a_hole_of_nan() {
    Mesh mesh = meshes::grid(12);
    mesh.positions[40] = vec3(std::numeric_limits<float>::quiet_NaN());
    return mesh;
}

Mesh enormous(float size) {
    Mesh mesh = torus({.n = 32}).mesh;
    for (vec3& p : mesh.positions) p *= size / 1.5f;
    return mesh;
}

std::vector<Mesh> all_meshes() {
    return {torus({.n = 64, .irregular = true}).mesh,
            waves({.n = 48}).mesh,
            noisy_torus(),
            meshes::sphere(24),
            meshes::box(),
            meshes::moebius(40),
            meshes::two_boxes_at_an_edge(),
            with_a_hole_of_nan(),
            enormous(1e18f),
            enormous(3e38f),
            Mesh("nothing", {})};
}

bool same(const Curves& a, const Curves& b) {
    constexpr std::size_t size = offsetof(CurvePiece, other) + sizeof(CurvePiece::other);
    static_assert(size == 13 * 4, "no gaps before the key");
    return std::ranges::equal(a, b, [](const CurvePiece& x, const CurvePiece& y) {
        return std::memcmp(&x, &y, size) == 0 && x.key == y.key;
    });
}

}  // namespace

TEST(Clusters, HoldEveryTriangleOnce) {
    for (const Mesh& mesh : all_meshes()) {
        const auto surface = mesh.surface();
        const auto clusters = clusters_of(*surface);
        std::vector<int> times(surface->triangles.size(), 0);
        for (Index c = 0; c < clusters->count(); ++c) {
            const In<Index> vertices = clusters->vertices[c];
            EXPECT_EQ(std::set(vertices.begin(), vertices.end()).size(), vertices.size());
            if (c + 1 < clusters->count()) {
                EXPECT_EQ(clusters->end(c) - clusters->begin(c), triangles_of_cluster);
            }
            for (Index i = clusters->begin(c); i < clusters->end(c); ++i) {
                const Index t = clusters->triangles[i];
                ++times[t];
                if (i > clusters->begin(c)) {
                    EXPECT_LT(clusters->triangles[i - 1], t);
                }
                for (int k = 0; k < 3; ++k) EXPECT_EQ(vertices[clusters->corners[i][k]], surface->triangles[t][k]);
            }
        }
        EXPECT_EQ(times, std::vector<int>(times.size(), 1)) << mesh.name;
    }
}

TEST(Clusters, LieTogether) {
    // A square of 64 x 64 cells in clusters of 64 triangles: squares of about 6 x 6 cells, never strips.
    const auto surface = meshes::grid(64).surface();
    for (const ClusterBounds& b : hierarchy_of(*surface)->clusters) EXPECT_LT(b.radius, 0.5f * 2.0f / 64.0f * 13.0f);
}

TEST(Clusters, RangesHoldWhatVerticesHave) {
    for (const Mesh& mesh : all_meshes()) {
        const auto surface = mesh.surface();
        const auto fields = fields_of(*surface);
        const auto clusters = clusters_of(*surface);
        const auto hierarchy = hierarchy_of(*surface);
        for (const Eye& eye : eyes()) {
            const SurfaceView seen = view_of(*surface, eye);
            for (Index c = 0; c < clusters->count(); ++c)
                for (const ClusterBounds* b : {&hierarchy->clusters[c], &hierarchy->groups[c / Hierarchy::group]}) {
                    const SeenCluster cluster(seen, *b);
                    const Range facing = cluster.facing(), bend = cluster.radial(), laplace = cluster.laplacian();
                    for (Index v : clusters->vertices[c]) {
                        const Curvature& k = fields->curvature[v];
                        const SeenOf<float> s = see_vertex(seen, k, v);
                        const RadialOf<float> r = radial(k, s);
                        ASSERT_TRUE(facing.may_hold(s.facing)) << mesh.name;
                        ASSERT_TRUE(bend.may_hold(r.scaled)) << mesh.name;
                        ASSERT_TRUE(laplace.may_hold(laplacian(k, s))) << mesh.name;
                        ASSERT_LE(std::abs(k.k1), b->curvature);
                        ASSERT_LE(std::abs(r.derivative), b->third + 2 * b->curvature * b->curvature);
                        ASSERT_FALSE(glm::distance(dvec3(surface->positions[v]), dvec3(b->center)) > b->radius);
                    }
                }
        }
    }
}

TEST(Clusters, WhatIsPassedOverHoldsNoLine) {
    int lines = 0;
    for (const Mesh& mesh : all_meshes()) {
        const auto surface = mesh.surface();
        for (const LineDefinition* definition : line_definitions()) {
            const auto* rule = std::get_if<CurveRule>(&definition->rule);
            if (!rule || definition->scope != Scope::view) continue;
            Values none_at_all;
            for (const Parameter& p : definition->parameters) none_at_all.push_back(p.low);
            for (const Eye& eye : eyes())
                for (const Values& v : {default_values(*definition), none_at_all}) {
                    SurfaceView seen = view_of(*surface, eye);
                    const Curves found = rule->find(seen, v);
                    seen.pass_over = false;
                    ASSERT_TRUE(same(found, rule->find(seen, v)))
                        << definition->name << " on " << mesh.name << " from (" << eye.at.x << ", " << eye.at.y << ", "
                        << eye.at.z << ")";
                    lines += !found.empty();
                }
        }
    }
    EXPECT_GT(lines, 1000);
}

TEST(Clusters, LinesAreThoseOfAllVertices) {
    // The definition written out over every vertex and triangle, in the order of triangles.
    const auto surface = waves({.n = 64, .irregular = true}).mesh.surface();
    const auto fields = fields_of(*surface);
    const float unit = 1.0f / (fields->feature_size * fields->feature_size);
    for (const Eye& eye : eyes()) {
        const SurfaceView seen = view_of(*surface, eye);
        const auto at = [&](Index v) { return see_vertex(seen, fields->curvature[v], v); };
        const auto strength = [](float) { return 1.0f; };
        const auto margin = [&](Index v) {
            const float derivative = radial(fields->curvature[v], at(v)).derivative;
            return vec2(derivative / std::max(at(v).facing, 0.05f) - 0.01f * unit, at(v).facing);
        };
        const Curves all = trace_zero_set(
            *surface, [&](Index v) { return radial(fields->curvature[v], at(v)).scaled; }, margin, strength);
        const Curves found = rule_of<CurveRule>("suggestive_contour").find(seen, {0.01, 1.0, 0.0});
        ASSERT_EQ(found.size(), all.size());
        for (std::size_t i = 0; i < all.size(); ++i) {
            EXPECT_EQ(found[i].triangle, all[i].triangle);
            for (int k = 0; k < 2; ++k) EXPECT_NEAR(glm::distance(found[i].point[k], all[i].point[k]), 0.0f, 1e-5f);
        }
    }
}

TEST(Clusters, WorkGrowsSlowerThanTheMesh) {
    // Glances at vertices, for a contour: four times the triangles, about twice the length of the contour in triangles.
    std::vector<double> glances;
    for (const int n : {64, 128, 256}) {
        const auto surface = torus({.n = n}).mesh.surface();
        const SurfaceView seen = view_of(*surface, {dvec3(2, 1.5, 5), false});
        const auto hierarchy = hierarchy_of(*surface);
        const auto clusters = clusters_of(*surface);
        double count = 0;
        const auto none_in = [](const SeenCluster& cluster) { return !cluster.facing().may_hold(0.0f); };
        for (Index c : clusters_with_lines(seen, *hierarchy, none_in)) count += double(clusters->vertices[c].size());
        glances.push_back(count);
    }
    EXPECT_GT(glances[0], 0.0);
    EXPECT_LT(glances[2] / glances[1], 2.6);
    EXPECT_LT(glances[2], 0.3 * 256 * 128);
}

TEST(Levels, CountThoseBelow) {
    const Levels levels{-1.0f, 0.1f, 20};
    for (int i = 1; i <= 20; ++i) {
        EXPECT_EQ(levels.below(levels[i]), i);
        EXPECT_EQ(levels.below(std::nextafter(levels[i], -10.0f)), i - 1);
        EXPECT_FALSE(levels.none_in({levels[i], levels[i]}));
        EXPECT_TRUE(levels.none_in({levels[i] + 0.03f, levels[i] + 0.07f}));
    }
    EXPECT_EQ(levels.below(-INFINITY), 0);
    EXPECT_EQ(levels.below(INFINITY), 20);
    EXPECT_EQ(levels.below(NAN), 0);
    EXPECT_FALSE(levels.none_in({-INFINITY, INFINITY}));
    EXPECT_FALSE(levels.none_in({NAN, NAN}));
}
