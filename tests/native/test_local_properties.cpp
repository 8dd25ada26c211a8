// SPDX-License-Identifier: GPL-3.0-or-later
// Local properties of pixels: of spheres, planes and tori in closed form, whatever their size and their side.
#include <gtest/gtest.h>
#include <random>

#include <fovea/field/exact_curvature.h>
#include <fovea/field/fields.h>
#include <fovea/field/view_curvature.h>
#include <fovea/study/curvature_at.h>
#include <fovea/study/local_properties.h>

#include "analytic.h"
#include "drawing.h"

namespace fovea {
namespace {

using namespace study;
using namespace drawing;

constexpr int width = 160, height = 120;
constexpr double unit = 0.01;  // feature size of a unit sphere

meshes::Mesh ball() { return analytic::icosphere(4, false); }

LocalProperties seen(std::vector<Placement> placements, const View& view) {
    const Scene scene(std::move(placements));
    return local_properties(Tracer(scene, view), Cancel());
}

float of(const LocalProperties& found, std::size_t pixel, Property property) {
    return found.rows[pixel][std::size_t(property)];
}

/// Looks down on the unit sphere, 40 pixels for a radius; and n . v of it at a pixel, below 0 beside it.
const View above = orthographic({0, 0, 10}, {0, 0, 0}, 4.0, width, height);
double facing_of_ball(std::size_t pixel, double radius = 40.0) {
    const dvec2 from = (center_of(pixel, width) - dvec2(width, height) / 2.0) / radius;
    const double left = 1.0 - glm::dot(from, from);
    return left < 0.0 ? -1.0 : std::sqrt(left);
}

/// Properties of a sphere in units of its feature size, where it is seen from at least `least` of n . v.
void expect_ball(const LocalProperties& found, double least = 0.2) {
    int seen = 0;
    for (std::size_t i = 0; i < found.rows.size(); ++i) {
        const double facing = facing_of_ball(i);
        if (facing < least) continue;
        ++seen;
        ASSERT_TRUE(found.known.set[i]);
        EXPECT_NEAR(of(found, i, Property::facing), facing, 0.01);
        EXPECT_NEAR(of(found, i, Property::luminance), facing, 0.01);
        EXPECT_NEAR(of(found, i, Property::first_curvature), unit, 2e-4);
        EXPECT_NEAR(of(found, i, Property::second_curvature), unit, 2e-4);
        EXPECT_NEAR(of(found, i, Property::mean_curvature), unit, 2e-4);
        EXPECT_NEAR(of(found, i, Property::gaussian_curvature), unit * unit, 4e-6);
        EXPECT_NEAR(of(found, i, Property::first_curvature_change), 0.0, 3e-5);
        EXPECT_NEAR(of(found, i, Property::view_curvature), unit / facing, 0.05 * unit / facing);
        EXPECT_NEAR(of(found, i, Property::radial_torsion), 0.0, 1e-4);
        if (facing < 0.99) {
            EXPECT_NEAR(of(found, i, Property::radial_curvature), unit, 2e-4);
        }
    }
    EXPECT_GT(seen, 4000);
}

}  // namespace

TEST(LocalProperties, OfASphereAreThoseOfItsRadius) { expect_ball(seen({place(ball())}, above)); }

TEST(LocalProperties, DoNotDependOnTheSizeOfAScene) {
    const View far = orthographic({0, 0, 100}, {0, 0, 0}, 28.0, width, height);
    expect_ball(seen({place(ball(), scaled(dvec3(7.0)))}, far));
}

TEST(LocalProperties, OfASurfaceThatIsSeenFromItsBackAreThoseOfItsOtherSide) {
    expect_ball(seen({place(meshes::flipped(ball(), [](int) { return true; }))}, above));
}

TEST(LocalProperties, OfAPlaneAreItsSlantAlone) {
    const View slanted = orthographic({6, 0, 8}, {0, 0, 0}, 4.0, width, height);
    const LocalProperties found = seen({place(meshes::grid(8, 20.0f))}, slanted);
    for (std::size_t i = 0; i < found.rows.size(); ++i) {
        ASSERT_TRUE(found.known.set[i]);
        for (std::size_t k = 0; k < property_count; ++k) {
            const bool is_tone = k == std::size_t(Property::facing) || k == std::size_t(Property::luminance);
            EXPECT_NEAR(found.rows[i][k], is_tone ? 0.8 : 0.0, 1e-5) << property_names[k].name;
        }
    }
}

TEST(LocalProperties, OfTheImageAreDerivativesOfItsTone) {
    // n . v of z = x^2 / 2 is 1 / sqrt(1 + x^2); the blur is narrow.
    const LocalProperties found =
        seen({place(meshes::relief(128, [](float x, float) { return 0.5f * x * x; }))}, above);
    const double sigma = 2.0 * std::hypot(width, height) / 1280.0;
    for (int x = width / 2 - 20; x < width / 2 + 20; ++x) {
        const auto pixel = std::size_t(height / 2 * width + x);
        const double at = (x + 0.5 - width / 2.0) / 40.0, facing = 1.0 / std::sqrt(1.0 + at * at);
        const double slope = sigma / 40.0 * at * std::pow(facing, 3.0);
        const double bend = sigma * sigma / 1600.0 * (2.0 * at * at - 1.0) * std::pow(facing, 5.0);
        EXPECT_NEAR(of(found, pixel, Property::luminance), facing, 1e-4);
        EXPECT_NEAR(of(found, pixel, Property::image_gradient), std::abs(slope), 3e-5);
        EXPECT_NEAR(of(found, pixel, Property::image_least_curvature), bend, 6e-6);
        EXPECT_NEAR(of(found, pixel, Property::image_most_curvature), 0.0, 2e-6);
    }
}

TEST(LocalProperties, AreKnownAWidthOfALineBesideSurfacesAndNowhereElse) {
    const LocalProperties found = seen({place(ball())}, above);
    const double beside = 4.0 * std::hypot(width, height) / 1280.0;
    for (std::size_t i = 0; i < found.rows.size(); ++i) {
        const double from = glm::distance(center_of(i, width), dvec2(width, height) / 2.0) - 40.0;
        if (from < -1.0) {
            EXPECT_TRUE(found.known.set[i]);
        }
        if (from > beside + 1.0) {
            EXPECT_EQ(found.rows[i], PropertyRow{});
        }
    }
    EXPECT_FALSE(found.known.set[0]);
}

TEST(LocalProperties, OfASurfaceWhoseLinesAreNotDrawnAreNotKnown) {
    const LocalProperties found = seen({place(ball(), dmat4(1.0), 1, usage_occlude)}, above);
    EXPECT_EQ(found.known.count(), 0u);
}

TEST(LocalProperties, OfATorusAreItsCurvaturesBetweenVerticesToo) {
    const double R = 1.0, r = 0.4;
    const analytic::Sample torus = analytic::torus({.n = 192}, R, r);
    const Placement placed = place(torus.mesh);
    const double size = field::fields_of(*placed.surface)->feature_size;
    const LocalProperties found = seen({placed}, above);
    for (std::size_t i = 0; i < found.rows.size(); ++i) {
        const dvec2 at = (center_of(i, width) - dvec2(width, height) / 2.0) / 40.0;
        const double from = glm::length(at) - R;
        if (std::abs(from) > 0.8 * r) continue;
        // Seen from above: n . v is the cosine of the angle around the tube.
        const double k1 = 1.0 / r, k2 = (from / r) / glm::length(at);
        EXPECT_NEAR(of(found, i, Property::first_curvature), size * k1, 0.02 * size * k1);
        EXPECT_NEAR(of(found, i, Property::second_curvature), size * k2, 0.03 * size * k1);
        EXPECT_NEAR(of(found, i, Property::facing), std::sqrt(1.0 - from * from / (r * r)), 0.02);
    }
}

TEST(LocalProperties, OfWavesAreThoseOfTheirExactCurvatureAtEachPixel) {
    const analytic::Sample waves = analytic::waves({.n = 192});
    const Placement placed = place(waves.mesh);
    const double size = field::fields_of(*placed.surface)->feature_size;
    const LocalProperties found = seen({placed}, above);
    using enum Property;
    const std::array compared{first_curvature,       second_curvature, first_curvature_change,  view_curvature,
                              view_curvature_change, radial_curvature, radial_curvature_change, radial_torsion};
    std::map<Property, std::pair<double, double>> sums;  // squared errors, and squares
    for (std::size_t i = 0; i < found.rows.size(); ++i) {
        const dvec2 at = (center_of(i, width) - dvec2(width, height) / 2.0) / 40.0;
        if (std::max(std::abs(at.x), std::abs(at.y)) > 0.85) continue;  // borders are fitted less well
        field::CurvatureD c = waves.exact(waves.point(0.5 * (at.x + 1.0), 0.5 * (at.y + 1.0)));
        if (std::abs(c.k2) > 0.9 * std::abs(c.k1)) continue;  // where the directions change places
        c.k1 *= size, c.k2 *= size;
        for (double& third : c.C) third *= size * size;
        const auto eye = field::see(c, dvec3(0, 0, 1), 0.0);
        const auto view = field::view_curvature(c, eye);
        const auto radial = field::radial(c, eye);
        if (eye.sine2() < 0.01) continue;  // where the radial direction is not defined
        const double as_seen = std::sqrt(view.squared);
        const std::array exact{c.k1,
                               c.k2,
                               std::abs(c.C[0]),
                               as_seen,
                               std::abs(view.derivative) / (2.0 * as_seen),
                               radial.curvature,
                               radial.derivative,
                               radial.torsion};
        for (std::size_t k = 0; k < compared.size(); ++k) {
            const double error = of(found, i, compared[k]) - exact[k];
            sums[compared[k]].first += error * error, sums[compared[k]].second += exact[k] * exact[k];
        }
    }
    for (const Property each : compared)
        EXPECT_LT(std::sqrt(sums[each].first / sums[each].second), 0.05) << property_names[std::size_t(each)].name;
}

TEST(MixedCurvature, OfEqualCornersIsTheirsAndKnowsNoSignOfTheirFrames) {
    std::mt19937 random(4);
    std::normal_distribution<float> normal;
    for (int n = 0; n < 200; ++n) {
        field::Curvature c{};
        c.normal = glm::normalize(vec3(normal(random), normal(random), normal(random)));
        c.e1 = glm::normalize(glm::cross(c.normal, vec3(normal(random), normal(random), normal(random))));
        c.e2 = glm::cross(c.normal, c.e1);
        c.k1 = 2.0f + std::abs(normal(random)), c.k2 = std::uniform_real_distribution<float>(-1.5f, 1.5f)(random);
        for (float& third : c.C) third = normal(random);
        field::Curvature other = c;  // the same form
        other.e1 = -c.e1, other.e2 = -c.e2;
        for (float& third : other.C) third = -third;
        const field::CurvatureD found = mixed(c, other, c, vec3(0.5f, 0.3f, 0.2f));
        EXPECT_NEAR(found.k1, c.k1, 1e-5);
        EXPECT_NEAR(found.k2, c.k2, 1e-5);
        EXPECT_LT(glm::distance(found.normal, dvec3(c.normal)), 1e-6);
        const double sign = glm::dot(found.e1, dvec3(c.e1)) < 0.0 ? -1.0 : 1.0;
        EXPECT_LT(glm::distance(sign * found.e1, dvec3(c.e1)), 1e-5);
        EXPECT_LT(glm::distance(glm::cross(found.e1, found.e2), found.normal), 1e-9);
        for (int k = 0; k < 4; ++k) EXPECT_NEAR(sign * found.C[k], c.C[k], 1e-4);
        const field::CurvatureD around = turned_around(found);
        EXPECT_EQ(around.k1, -found.k1);
        EXPECT_LT(glm::distance(glm::cross(around.e1, around.e2), around.normal), 1e-9);
        const field::CurvatureD back = turned_around(around);
        for (int k = 0; k < 4; ++k) EXPECT_EQ(back.C[k], found.C[k]);
    }
}

}  // namespace fovea
