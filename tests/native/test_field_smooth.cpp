// SPDX-License-Identifier: GPL-3.0-or-later
// Curvature averaged over its surroundings: what must stay as it is, and noise, which must not.
#include <glm/gtc/quaternion.hpp>
#include <gtest/gtest.h>

#include <fovea/field/fields.h>
#include <fovea/field/smooth.h>

#include "field_errors.h"

using namespace fovea;
using namespace fovea::draw;
using namespace fovea::analytic;

namespace {

Array<Curvature> exact(const Sample& sample) {
    Array<Curvature> found;
    for (const vec3& p : sample.mesh.positions) found.push_back(rounded(sample.exact(dvec3(p))));
    return found;
}

Array<Curvature> smoothed(const Surface& surface, const Array<Curvature>& curvature, double deviation) {
    return smooth(surface, *neighbors_of(surface), curvature, deviation);
}

Sample noisy_torus(double share_of_edge) {
    Sample sample = torus({.n = 128});
    std::mt19937 random(5);
    std::normal_distribution<float> offset(0.0f, static_cast<float>(share_of_edge * 0.045));
    for (vec3& p : sample.mesh.positions) p += offset(random) * vec3(sample.exact(dvec3(p)).normal);
    return sample;
}

}  // namespace

TEST(FieldSmooth, SpheresAndCylindersStay) {
    const Sample sphere = ellipsoid(4, true, dvec3(2.0));
    for (const Curvature& c : smoothed(*sphere.mesh.surface(), exact(sphere), 2.0)) {
        EXPECT_NEAR(c.k1, 0.5f, 1e-5f);
        EXPECT_NEAR(c.k2, 0.5f, 1e-5f);
        for (float third : c.C) EXPECT_NEAR(third, 0.0f, 1e-5f);
    }
    Sample cylinder{parameter_grid("cylinder", false, {.n = 40, .irregular = true},
                                   [](double u, double v) { return dvec3(std::cos(3 * v), std::sin(3 * v), 3 * u); }),
                    {},
                    {}};
    cylinder.exact = [](const dvec3& p) { return curvature_of(ellipsoid_jet({p.x, p.y, 0}, {1, 1, 1e30})); };
    const auto before = exact(cylinder);
    const auto after = smoothed(*cylinder.mesh.surface(), before, 2.0);
    for (std::size_t v = 0; v < after.size(); ++v) {
        EXPECT_NEAR(std::abs(after[v].k1), 1.0f, 1e-4f);
        EXPECT_NEAR(after[v].k2, 0.0f, 1e-4f);
        EXPECT_NEAR(std::abs(glm::dot(after[v].e1, before[v].e1)), 1.0f, 1e-4f);
        for (float third : after[v].C) EXPECT_NEAR(third, 0.0f, 1e-3f);
    }
}

TEST(FieldSmooth, TakesNoiseAway) {
    // Estimated as if there were none: jets of degree 4 over 3 rings.
    const Sample sample = noisy_torus(0.01);
    const auto surface = sample.mesh.surface();
    FieldOptions options{.estimator = Estimator::jets, .degree = 4, .rings = 3};
    const Errors before = errors_of(sample, fields_of(*surface, options)->curvature);
    options.smoothing = 1.5;
    const auto fields = fields_of(*surface, options);
    const Errors after = errors_of(sample, fields->curvature);
    EXPECT_LT(after.k_median, 0.1 * before.k_median);
    EXPECT_LT(after.c_median, 0.1 * before.c_median);
    EXPECT_NE(fields->reason.find("smoothed over 1.5 edges"), std::string::npos) << fields->reason;
}

TEST(FieldSmooth, LeavesTheFittedNormals) {
    const auto surface = noisy_torus(0.02).mesh.surface();
    const Array<Index> some{5, 300, 301, 8000};
    const Array<vec3> normals = fitted_normals(*surface, some);  // before there are fields
    const auto fields = fields_of(*surface);
    EXPECT_NE(fields->reason.find("smoothed"), std::string::npos) << fields->reason;
    for (std::size_t i = 0; i < some.size(); ++i) EXPECT_EQ(normals[i], fields->curvature[some[i]].normal);
    EXPECT_LE(fields->feature_size, greatest_feature_size(*surface));
}

TEST(FieldSmooth, MovesAndGrowsWithTheSurface) {
    const Sample sample = waves({.n = 24, .irregular = true});
    Mesh moved = sample.mesh;
    const glm::dquat turn = glm::angleAxis(1.1, glm::normalize(dvec3(1, 2, -1)));
    for (vec3& p : moved.positions) p = vec3(2.0 * (turn * dvec3(p)) + dvec3(3, 1, -2));
    const FieldOptions options{.estimator = Estimator::jets, .degree = 3, .rings = 2, .smoothing = 1.0};
    const auto here = fields_of(*sample.mesh.surface(), options), there = fields_of(*moved.surface(), options);
    double third[4];
    for (std::size_t v = 0; v < here->curvature.size(); ++v) {
        const Curvature &a = here->curvature[v], &b = there->curvature[v];
        EXPECT_NEAR(a.k1, 2.0f * b.k1, 2e-2f);
        EXPECT_NEAR(a.k2, 2.0f * b.k2, 2e-2f);
        in_frame(b, turn * dvec3(a.e1), turn * dvec3(a.e2), third);
        for (int i = 0; i < 4; ++i) EXPECT_NEAR(a.C[i], 4.0 * third[i], 0.02 * (1.0 + norm(a.C))) << v;
    }
    EXPECT_NEAR(2.0f * here->feature_size, there->feature_size, 1e-3f);
}

TEST(FieldSmooth, DoesNotCrossHardEdges) {
    // Half a tube on a flat plate, and on the hard edges between them what must not be heard of elsewhere.
    const Mesh mesh = parameter_grid("plate and tube", false, {.n = 24}, [](double u, double v) {
        if (v <= 0.5) return dvec3(3 * u, 4 * v - 2, 0);
        const double a = std::numbers::pi * (2 * v - 1);
        return dvec3(3 * u, 1 - std::cos(a), std::sin(a));
    });
    const auto surface = mesh.surface();
    const auto neighbors = neighbors_of(*surface);
    Array<Curvature> before(surface->vertex_count(), Curvature{});
    for (Index v = 0; v < before.size(); ++v) {
        const vec3 p = surface->positions[v];
        Curvature& c = before[v];
        c.normal = p.y < 0.01f ? vec3(0, 0, 1) : vec3(0, p.y - 1, p.z);
        c.e2 = vec3(1, 0, 0);
        c.e1 = glm::cross(c.e2, c.normal);
        c.k1 = neighbors->hard[v] ? 1000.0f : p.y < 0.01f ? 0.0f : 1.0f;
    }
    const Array<Curvature> after = smoothed(*surface, before, 2.0);
    int hard = 0;
    for (Index v = 0; v < before.size(); ++v) {
        hard += neighbors->hard[v];
        if (neighbors->hard[v]) continue;
        EXPECT_NEAR(after[v].k1, before[v].k1, 1e-4f) << surface->positions[v].y;
    }
    EXPECT_EQ(hard, 25);
}
