// SPDX-License-Identifier: GPL-3.0-or-later
// Distance to surfaces against closed forms, and the focus made of it.
#include <cmath>
#include <gtest/gtest.h>
#include <random>

#include <fovea/focus/at_samples.h>
#include <fovea/focus/focus.h>
#include <fovea/scene/distance.h>
#include <fovea/visibility/depth_image.h>

#include "drawing.h"

using namespace fovea;
using namespace fovea::draw;

namespace {

const View& view() {
    static const View seen = drawing::perspective({3, -4, 2.5}, {0, 0, 0});
    return seen;
}

/// A place of the world in view space.
vec3 seen(const dvec3& world) { return vec3(view().world_to_view * dvec4(world, 1.0)); }

SurfaceDistance distance_from(const std::vector<Placement>& placements) {
    Array<Index> all;
    for (Index i = 0; i < placements.size(); ++i) all.push_back(i);
    return SurfaceDistance(Scene(placements), view(), all);
}

/// From the surface of a box, inside and outside.
double from_box(const dvec3& p, const dvec3& half) {
    const dvec3 q = glm::abs(p) - half;
    return std::abs(glm::length(glm::max(q, dvec3(0.0))) + std::min(std::max({q.x, q.y, q.z}), 0.0));
}

template <typename Check>
void at_random_places(double reach, const Check& check) {
    std::mt19937 random(7);
    std::uniform_real_distribution<double> along(-reach, reach);
    for (int i = 0; i < 500; ++i) {
        const double x = along(random), y = along(random), z = along(random);
        check(dvec3(x, y, z));
    }
}

}  // namespace

TEST(SurfaceDistance, OfABoxThatIsStretchedAndMoved) {
    const dmat4 placed = drawing::moved({1, 2, -0.5}) * drawing::scaled({2, 0.5, 1});
    const SurfaceDistance distance = distance_from({drawing::place(meshes::box(), placed)});
    at_random_places(6.0, [&](const dvec3& p) {
        const double expected = from_box(p - dvec3(1, 2, -0.5), dvec3(2, 0.5, 1));
        EXPECT_NEAR(distance(seen(p), infinity), expected, 2e-5);
    });
}

TEST(SurfaceDistance, OfASphere) {
    const SurfaceDistance distance = distance_from({drawing::place(meshes::sphere(96))});
    at_random_places(4.0, [&](const dvec3& p) {
        // The mesh lies inside the sphere by less than 1 - cos of half a segment.
        EXPECT_NEAR(distance(seen(p), 100.0f), std::abs(glm::length(p) - 1.0), 1.2e-3);
    });
}

TEST(SurfaceDistance, FarChangesNothingThatIsNearer) {
    const SurfaceDistance distance = distance_from({drawing::place(meshes::sphere(24))});
    int beyond = 0;
    at_random_places(3.0, [&](const dvec3& p) {
        const float all = distance(seen(p), infinity), near = distance(seen(p), 0.75f);
        EXPECT_EQ(near, all <= 0.75f ? all : infinity);
        beyond += near == infinity;
    });
    EXPECT_GT(beyond, 50);
    EXPECT_LT(beyond, 450);
}

TEST(SurfaceDistance, OfSeveralTheNearestAndOnlyOfThoseAskedFor) {
    const std::vector<Placement> placements{drawing::place(meshes::box()),
                                            drawing::place(meshes::box(), drawing::moved({6, 0, 0}), 2),
                                            drawing::place(meshes::box(), drawing::moved({-4, 0, 0}), 3)};
    const Index first_two[] = {0, 1};
    const SurfaceDistance distance(Scene(placements), view(), first_two);
    EXPECT_NEAR(distance(seen({4, 0, 0}), 10), 1.0f, 1e-5f);
    EXPECT_NEAR(distance(seen({2, 0, 0}), 10), 1.0f, 1e-5f);
    EXPECT_NEAR(distance(seen({-4, 0, 0}), 10), 3.0f, 1e-5f);
    EXPECT_NEAR(distance(seen({0, 0, 0}), 10), 1.0f, 1e-5f);  // inside
}

TEST(SurfaceDistance, OfWhatHidesNothingToo) {
    meshes::Mesh glass = meshes::box();
    glass.occluding.assign(6, 0);
    EXPECT_NEAR(distance_from({drawing::place(glass)})(seen({3, 0, 0}), 10), 2.0f, 1e-5f);
}

TEST(SurfaceDistance, OfNothingIsInfinite) {
    EXPECT_EQ(distance_from({})({0, 0, 0}, 10), infinity);
    const SurfaceDistance distance = distance_from({drawing::place(meshes::box())});
    EXPECT_EQ(distance({NAN, 0, 0}, 10), infinity);
    EXPECT_EQ(distance({infinity, 0, 0}, infinity), infinity);
    const Index wrong[] = {3};
    EXPECT_THROW(SurfaceDistance(Scene(), view(), wrong), std::invalid_argument);
}

TEST(SurfaceDistance, MakesFocusFallOffFromASurface) {
    const auto box = std::make_shared<SurfaceDistance>(distance_from({drawing::place(meshes::box())}));
    Focus focus{FocusSpace::scene, {{vec3(0), 1, 3, box}}};
    EXPECT_EQ(focus({}, seen({1.9, 0, 0})), 0.0f);
    EXPECT_NEAR(focus({}, seen({3, 0, 0})), 0.5f, 1e-5f);
    EXPECT_EQ(focus({}, seen({4.1, 0, 0})), 1.0f);
    // A step, and another place beside it.
    focus.points[0].near = focus.points[0].far = 1.0f;
    EXPECT_EQ(focus({}, seen({5, 0, 0})), 1.0f);
    focus.points.push_back({seen({6, 0, 0}), 0, 2});
    EXPECT_NEAR(focus({}, seen({5, 0, 0})), 0.5f, 1e-5f);
}

TEST(SurfaceDistance, FocusOfPixelsAndSamplesIsThatOfTheirPlaces) {
    const drawing::Drawing drawn({drawing::place(meshes::sphere(24)), drawing::place(meshes::grid(6, 4.0f))}, view(),
                                 {drawing::line_set({"contour", "border", "topographic"})});
    const Index ball[] = {0};
    const auto surface = std::make_shared<SurfaceDistance>(drawn.scene, view(), ball);
    const Array<float> depth = depth_image(drawn.tracer, Cancel());
    const dmat4 clip_to_view = glm::inverse(view().view_to_clip);
    for (const float far : {0.3f, 2.0f}) {
        const Focus focus{FocusSpace::scene, {{vec3(0), 0.2f, far, surface}}};
        const Array<float> pixels = focus_of_pixels(view(), depth, focus);
        double error = 0.0;
        for (std::size_t i = 0; i < pixels.size(); ++i) {
            const dvec2 px(i % view().width + 0.5, i / view().width + 0.5);
            const bool nothing = !std::isfinite(depth[i]) || depth[i] >= background_depth;
            const float expected = nothing ? 1.0f : focus({}, vec3(from_pixels(view(), clip_to_view, px, depth[i])));
            ASSERT_NEAR(pixels[i], expected, focus_tolerance) << i;
            error += std::abs(pixels[i] - expected);
        }
        EXPECT_LT(error / double(pixels.size()), 2e-4) << far;
        const Array<float> samples = focus_of_samples(drawn.clipped, focus);
        const auto exact = [&](const SamplePlace& at) { return focus({}, position_at(drawn.clipped, at)); };
        const Array<float> expected = at_samples(drawn.clipped, exact);
        for (std::size_t s = 0; s < samples.size(); ++s) EXPECT_NEAR(samples[s], expected[s], focus_tolerance);
    }
}

TEST(NearestPoint, OfABoxIsThePlaceClampedToIt) {
    const Surface box("box", meshes::box().arrays());
    const NearestPoint nearest(box.positions, box.triangles);
    at_random_places(3.0, [&](const dvec3& place) {
        const vec3 p(place);
        if (glm::all(glm::lessThan(glm::abs(p), vec3(1.0f)))) return;  // inside
        const std::optional<dvec3> found = nearest(p);
        ASSERT_TRUE(found);
        EXPECT_LT(glm::distance(*found, glm::clamp(dvec3(p), -1.0, 1.0)), 1e-12);
        EXPECT_FALSE(nearest(p, 0.5f * static_cast<float>(glm::distance(*found, dvec3(p)))));
    });
    EXPECT_FALSE(nearest(vec3(std::nanf(""), 0, 0)));
    EXPECT_FALSE(NearestPoint({}, {})(vec3(3.0f)));
}
