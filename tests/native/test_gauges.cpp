// SPDX-License-Identifier: GPL-3.0-or-later
// Gauges on boxes and balls, as cameras see them, and reliefs.
#include <gtest/gtest.h>

#include <fovea/study/bas_relief.h>
#include <fovea/study/gauges.h>

#include "drawing.h"

namespace fovea {
namespace {

using namespace drawing;
using study::gauge_normal;
using study::GaugePlaces;

dvec3 slanted(double degrees, double tilt) {
    const double slant = glm::radians(degrees);
    return {std::sin(slant) * std::cos(tilt), std::sin(slant) * std::sin(tilt), std::cos(slant)};
}

double degrees_between(const dvec3& a, const dvec3& b) { return glm::degrees(study::angle_between(a, b)); }

/// Degrees between the gauge of a small disc and the ellipse that the projections of its border are.
double off_from_projected(const View& view, const dvec3& place, const dvec3& normal) {
    const auto px = [&](const dvec3& p) { return to_pixels(view, view.view_to_clip * dvec4(p, 1.0)); };
    const dvec3 a = glm::normalize(glm::cross(normal, dvec3(0.3, 0.5, 0.8))), b = glm::cross(normal, a);
    const double radius = 1e-5;
    double most = 0.0, least = 1e9;
    dvec2 minor;
    for (int i = 0; i < 3600; ++i) {
        const double t = 2.0 * std::numbers::pi * i / 3600.0;
        const dvec2 away = px(place + radius * (std::cos(t) * a + std::sin(t) * b)) - px(place);
        most = std::max(most, glm::length(away));
        if (glm::length(away) < least) least = glm::length(away), minor = glm::normalize(away);
    }
    if (glm::dot(minor, px(place + radius * normal) - px(place)) < 0.0) minor = -minor;
    const double narrow = std::min(1.0, least / most);
    return degrees_between(gauge_normal(view, place, normal), {std::sqrt(1.0 - narrow * narrow) * minor, narrow});
}

TEST(Gauges, WithoutPerspectiveTheyHaveTheNormalsOfTheSurface) {
    const View view = orthographic({0, 0, 5}, {0, 0, 0}, 4.0);
    for (const double slant : {0.0, 1.0, 30.0, 60.0, 85.0})
        for (int i = 0; i < 8; ++i) {
            const dvec3 normal = slanted(slant, 0.1 + i * std::numbers::pi / 4.0);
            EXPECT_LT(degrees_between(gauge_normal(view, {1.3, -0.8, -4.0}, normal), normal), 1e-5);
            EXPECT_LT(degrees_between(gauge_normal(view, {1.3, -0.8, -4.0}, -normal), normal), 1e-5) << "from below";
        }
}

TEST(Gauges, WithPerspectiveTheyLookAsSmallDiscsDo) {
    const View view = perspective({0, 0, 5}, {0, 0, 0}, 28.0);
    for (const double slant : {5.0, 40.0, 75.0})
        for (int i = 0; i < 8; ++i) {
            const dvec3 normal = slanted(slant, 0.1 + i * std::numbers::pi / 4.0);
            EXPECT_LT(degrees_between(gauge_normal(view, {0.0, 0.0, -4.0}, normal), normal), 1e-5) << "in the middle";
            for (const dvec3 place : {dvec3(1.0, 0.5, -4.0), dvec3(-1.5, 1.1, -4.0)})
                if (glm::dot(normal, -place) > 0.1) {
                    EXPECT_LT(off_from_projected(view, place, normal), 0.3) << slant << " " << i;
                }
        }
    const dvec3 off_middle = gauge_normal(view, {1.5, 0.0, -4.0}, {0, 0, 1});
    EXPECT_LT(degrees_between(off_middle, {0, 0, 1}), 1e-5) << "parallel to the picture: a disc is a circle everywhere";
}

TEST(Gauges, OfABallTheyAreItsNormals) {
    meshes::Mesh mesh = meshes::sphere(96);
    mesh.shape = Shape::smooth;
    const View view = orthographic({0, 0, 5}, {0, 0, 0}, 4.0, 400, 300);  // 100 pixels to a unit
    const Scene scene({place(mesh)});
    const Tracer tracer(scene, view);
    std::vector<dvec2> px;
    for (int i = 0; i < 60; ++i) px.push_back(dvec2(200.0, 150.0) + 1.5 * i * dvec2(std::cos(i), std::sin(i)));
    const GaugePlaces found = study::gauge_places(tracer, px, 6.0);
    for (std::size_t i = 0; i < px.size(); ++i) {
        const dvec2 at = (px[i] - dvec2(200.0, 150.0)) / 100.0;
        if (glm::length(at) > 0.93) {
            EXPECT_EQ(found.placement[i], none) << "the outline is within the radius";
        } else if (glm::length(at) < 0.85) {
            ASSERT_EQ(found.placement[i], 0u) << i;
            EXPECT_LT(degrees_between(found.normal[i], {at, std::sqrt(1.0 - glm::dot(at, at))}), 2.0) << i;
        }
    }
}

TEST(Gauges, NoPlaceIsAtACreaseOrAStepOrWhereNothingIs) {
    // Two boxes in one mesh, one before the other, as seen from the front: a step at x = 0.
    meshes::Mesh mesh =
        meshes::with_another(meshes::box({-1, -1, -1}, {0, 1, 1}), meshes::box({-5, -1, -1}, {-4, 1, 0}));
    const View view = orthographic({0, 0, 5}, {0, 0, 0}, 4.0, 400, 300);
    const Scene scene({place(mesh)});
    const std::vector<dvec2> px{{150, 150}, {196, 150}, {204, 150}, {250, 150}, {20, 150}};
    const GaugePlaces front = study::gauge_places(Tracer(scene, view), px, 6.0);
    EXPECT_EQ(front.placement[0], 0u);
    EXPECT_EQ(front.placement[1], none);
    EXPECT_EQ(front.placement[2], none);
    EXPECT_EQ(front.placement[3], 0u);
    EXPECT_EQ(front.placement[4], none);
    EXPECT_LT(degrees_between(front.normal[3], {0, 0, 1}), 1e-3);
    EXPECT_EQ(front.normal[4], dvec3(0.0));

    const Scene one({place(meshes::box())});
    const View edgewise = orthographic({5, 0, 5}, {0, 0, 0}, 4.0, 400, 300);  // its edge is a line at y = 150
    const std::vector<dvec2> beside{{200, 150}, {200, 153}, {200, 162}};
    const GaugePlaces found = study::gauge_places(Tracer(one, edgewise), beside, 6.0);
    EXPECT_EQ(found.placement[0], none);
    EXPECT_EQ(found.placement[1], none);
    ASSERT_EQ(found.placement[2], 0u);
    EXPECT_NEAR(std::abs(found.normal[2].y), std::sqrt(0.5), 1e-3);
    EXPECT_NEAR(found.normal[2].z, std::sqrt(0.5), 1e-3);
}

TEST(Gauges, ARadiusThatIsNoneIsRefused) {
    const Scene scene({place(meshes::box())});
    const Tracer tracer(scene, perspective({5, -4, 3}, {0, 0, 0}));
    EXPECT_THROW(study::gauge_places(tracer, std::vector<dvec2>{{1, 1}}, NAN), std::invalid_argument);
}

TEST(BasRelief, TheBestOneIsFoundAcrossTheBounds) {
    std::vector<dvec3> normals;
    for (int i = 0; i < 40; ++i) normals.push_back(slanted(5.0 + 1.9 * i, 2.4 * i));
    for (const study::BasRelief wanted : {study::BasRelief{1.0, {0, 0}}, {0.15, {0.8, -0.5}}, {8.0, {-2.0, 3.0}}}) {
        std::vector<dvec3> onto;
        for (const dvec3& n : normals) onto.push_back(wanted.of_normal(n));
        const study::BasRelief found = study::fitted_relief(normals, onto);
        EXPECT_NEAR(found.depth / wanted.depth, 1.0, 1e-4);
        EXPECT_NEAR(glm::distance(found.slope, wanted.slope), 0.0, 1e-3);
    }
    const std::vector<dvec3> flat(40, dvec3(0, 0, 1));
    EXPECT_NEAR(study::fitted_relief(normals, flat).depth, study::least_depth, 1e-3);
    EXPECT_THROW(study::fitted_relief(flat, {}), std::invalid_argument);
}

}  // namespace
}  // namespace fovea
