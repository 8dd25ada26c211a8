// SPDX-License-Identifier: GPL-3.0-or-later
// Outlines of shadows: known in closed form, and by rays.
#include <gtest/gtest.h>
#include <random>

#include "analytic.h"
#include "shadows.h"

using namespace fovea;
using namespace fovea::draw;
using namespace fovea::drawing;
using namespace fovea::meshes;
using namespace fovea::shadows;

namespace {

const dvec3 slanted = glm::normalize(dvec3(0.5, -0.3, 1.0));

Lines shadows_of(std::vector<Placement> placements, std::vector<Light> lights, const Values& values = {4, 0}) {
    return Lines(std::move(placements), std::move(lights), line_set_with("cast_shadow", values));
}

Placement floor_at(double z, std::uint64_t id = 9) { return place(grid(1, 20.0f), moved({0, 0, z}), id); }

/// Corners of the convex hull of points in a plane, counterclockwise. Andrew, 1979.
std::vector<dvec2> hull(std::vector<dvec2> points) {
    std::ranges::sort(points, [](const dvec2& a, const dvec2& b) { return std::tie(a.x, a.y) < std::tie(b.x, b.y); });
    std::vector<dvec2> corners;
    for (int half = 0; half < 2; ++half) {
        const std::size_t first = corners.size();
        for (const dvec2& p : points) {
            while (corners.size() >= first + 2 &&
                   base::cross(corners.back() - corners[corners.size() - 2], p - corners.back()) <= 0.0)
                corners.pop_back();
            corners.push_back(p);
        }
        corners.pop_back();
        std::ranges::reverse(points);
    }
    return corners;
}

double distance_to_polygon(const dvec2& p, const std::vector<dvec2>& corners) {
    double least = 1e30;
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const dvec2 a = corners[i], way = corners[(i + 1) % corners.size()] - a;
        const double t = std::clamp(glm::dot(p - a, way) / glm::dot(way, way), 0.0, 1.0);
        least = std::min(least, glm::distance(p, a + t * way));
    }
    return least;
}

double length_of(const std::vector<dvec2>& corners) {
    double sum = 0.0;
    for (std::size_t i = 0; i < corners.size(); ++i)
        sum += glm::distance(corners[i], corners[(i + 1) % corners.size()]);
    return sum;
}

/// Whether points of the floor lie in shadow, as rays tell, is whether the way out of it crosses an odd number of
/// lines.
void expect_parity(const Lines& lines, Index floor, const Light& light, double z, double half, double margin) {
    const std::vector<Segment> segments = lines.on(floor);
    std::mt19937 random(7);
    std::uniform_real_distribution<double> place(-half, half);
    int wrong = 0, dark = 0, counted = 0;
    for (int n = 0; n < 50000; ++n) {
        const dvec2 p(place(random), place(random)), out(173.1, 57.7);
        bool odd = false, near = false;
        for (const Segment& s : segments) {
            const dvec2 a(s.a), b(s.b), way = b - a;
            const double t =
                glm::dot(way, way) > 0 ? std::clamp(glm::dot(p - a, way) / glm::dot(way, way), 0.0, 1.0) : 0;
            near = near || glm::distance(p, a + t * way) < margin;
            const double of_a = base::cross(out - p, a - p), of_b = base::cross(out - p, b - p);
            if ((of_a < 0.0) == (of_b < 0.0)) continue;
            odd ^= (base::cross(way, p - a) < 0.0) != (base::cross(way, out - a) < 0.0);
        }
        if (near) continue;
        const bool lit = is_lit(lines.scene, light, dvec3(p, z), floor);
        ++counted;
        dark += !lit;
        wrong += lit == odd;
    }
    EXPECT_GT(dark, counted / 50);
    EXPECT_EQ(wrong, 0) << "of " << counted;
}

Mesh tumbled_torus() { return analytic::torus({.n = 24}).mesh; }

}  // namespace

TEST(CastShadow, OfASphereByTheSunIsAnEllipse) {
    const int n = 32;
    const double edge = std::numbers::pi / n;
    const dvec3 c(0.3, 0.2, 2.5);
    const Lines found = shadows_of({place(sphere(n), moved(c), 1), floor_at(0.0)}, {sun(slanted)});
    const std::vector<Segment> on_floor = found.on(1);
    EXPECT_EQ(found.closed, 1u);
    const auto distance = [&](const dvec3& x) {
        const double along = glm::dot(x - c, slanted);
        return std::abs(std::sqrt(glm::dot(x - c, x - c) - along * along) - 1.0) / edge;
    };
    const Errors errors(on_floor, 0.25, distance);
    EXPECT_LT(errors.median, 0.02);
    EXPECT_LT(errors.most, 0.05);
    EXPECT_EQ(errors.beyond, 0.0);
    const double a = 1.0 / slanted.z, h = std::pow((a - 1) / (a + 1), 2);
    const double around = std::numbers::pi * (a + 1) * (1 + 3 * h / (10 + std::sqrt(4 - 3 * h)));
    EXPECT_NEAR(length(on_floor) / around, 1.0, 0.005);
}

TEST(CastShadow, OfASphereByALampIsAConic) {
    const int n = 32;
    const double edge = std::numbers::pi / n;
    const dvec3 c(0.0, 0.0, 2.0), at(2.0, 1.0, 6.0);
    const Lines found = shadows_of({place(sphere(n), moved(c), 1), floor_at(0.0)}, {lamp(at)});
    EXPECT_EQ(found.closed, 1u);
    const double away = glm::length(c - at), tangent = std::sqrt(away * away - 1.0);
    // How far a ray of the shadow passes the center, as the tangent cone does at the distance of the radius.
    const auto distance = [&](const dvec3& x) {
        const dvec3 ray = glm::normalize(x - at);
        return std::abs(glm::length(glm::cross(c - at, ray)) - 1.0) * away / tangent / edge;
    };
    const Errors errors(found.on(1), 0.25, distance);
    EXPECT_LT(errors.median, 0.02);
    EXPECT_LT(errors.most, 0.05);
    EXPECT_EQ(errors.beyond, 0.0);
}

TEST(CastShadow, OfABoxIsTheHullOfItsCorners) {
    for (const Light& light : {sun(slanted), sun({0, 0, 1}), sun({1, 0, 1}), lamp({1, 2, 7}), lamp({0, 0, 8})}) {
        const Mesh mesh = box();
        const dvec3 up(0, 0, 2.5);
        const Lines found = shadows_of({place(mesh, moved(up), 1), floor_at(0.0)}, {light});
        std::vector<dvec2> corners;
        for (const vec3& p : mesh.positions) {
            const dvec3 at = dvec3(p) + up, way = light.kind == Light::sun ? light.direction : at - light.position;
            corners.push_back(dvec2(at - way * (at.z / way.z)));
        }
        corners = hull(corners);
        EXPECT_EQ(found.closed, 1u);
        EXPECT_NEAR(length(found.on(1)), length_of(corners), 2e-3);
        for (const Segment& s : found.on(1)) EXPECT_LT(distance_to_polygon(dvec2(s.middle()), corners), 5e-4);
    }
}

TEST(CastShadow, OfAPolygonWithCornersInOnePlaceIsClosed) {
    for (const int corners : {2, 3, 5}) {
        Mesh mesh("polygon", {{-1, -1, 2}, {1, -1, 2}, {-1, 1, 2}});
        std::vector<int> polygon{0, 1};
        for (int i = 0; i < corners; ++i) {
            polygon.push_back(int(mesh.positions.size()));
            mesh.positions.push_back({1, 1, 2});
        }
        polygon.push_back(2);
        mesh.add_polygon(polygon);
        const Lines found = shadows_of({place(mesh, dmat4(1.0), 1), floor_at(0.0)}, {sun(slanted)});
        EXPECT_EQ(found.ids.size(), 1u) << corners;
        EXPECT_EQ(found.closed, 1u) << corners;
        EXPECT_NEAR(length(found.on(1)), 8.0, 1e-3) << corners;
    }
}

TEST(CastShadow, OfAnEdgeWithoutEndEnds) {
    Mesh mesh("blade", {{-1e20f, 0, 2}, {1e20f, 0, 2}, {0, 1, 2}});
    mesh.add_polygon({0, 1, 2});
    const Lines found =
        shadows_of({place(mesh, dmat4(1.0), 1), place(grid(1), moved({0, 0, 0}), 2)}, {sun({0.1, 0.2, 1})});
    for (const Segment& s : found.segments) EXPECT_TRUE(std::isfinite(s.length()));
}

TEST(CastShadow, OfASphereOnAnotherFulfilsTheEquationsOfBoth) {
    const dvec3 c(0, 0, 4), below(0.4, 0.2, 0);
    const Lines found = shadows_of(
        {place(sphere(48), moved(c), 1), place(sphere(24), moved(below) * scaled(dvec3(2)), 2)}, {sun({0.1, 0, 1})});
    ASSERT_FALSE(found.on(1).empty());
    const dvec3 towards = glm::normalize(dvec3(0.1, 0, 1));
    for (const Segment& s : found.on(1)) {
        const double along = glm::dot(s.a - c, towards);
        EXPECT_NEAR(std::sqrt(glm::dot(s.a - c, s.a - c) - along * along), 1.0, 0.01);
        EXPECT_NEAR(glm::distance(s.a, below), 2.0, 0.02);
    }
    EXPECT_EQ(found.closed, 1u);
}

TEST(CastShadow, PartsShadowFromLightAsRaysDo) {
    const dmat4 tumbled = glm::rotate(moved({0, 0, 3}), 0.9, dvec3(1, 0.3, 0.2));
    const std::vector<Placement> placements = {place(tumbled_torus(), tumbled, 1),
                                               place(box(), moved({1.5, 1, 5}) * scaled(dvec3(0.6)), 2),
                                               place(cylinder(24), moved({-2, -1, 3}) * tumbled, 3), floor_at(0.0)};
    for (const Light& light : {sun(slanted), lamp({1, -1, 12})})
        expect_parity(shadows_of(placements, {light}), 3, light, 0.0, 8.0, 0.01);
}

TEST(CastShadow, FallsOverEdgesWithoutGaps) {
    // A bar over three steps: its shadow is as long as the steps are, wherever their edges are.
    const Mesh bar = box({-3, -0.1f, 5}, {3, 0.1f, 5.2f});
    const std::vector<Placement> stairs = {place(bar, dmat4(1.0), 1),
                                           place(box({-4, -1, -1}, {-1, 1, 0}), dmat4(1.0), 2),
                                           place(box({-1, -1, -1}, {1, 1, 1}), dmat4(1.0), 3), floor_at(-1.0)};
    const Lines found = shadows_of(stairs, {sun({0, 0.01, 1})});
    const auto across = [&](Index placement) {
        double sum = 0.0;
        for (const Segment& s : found.on(placement))
            if (std::abs(s.a.z - s.b.z) < 1e-6 && std::abs(s.a.y) < 0.9) sum += std::abs(s.a.x - s.b.x);
        return sum;
    };
    EXPECT_NEAR(across(1), 4.0, 1e-3);  // both sides of the bar, from x = -3 to -1
    EXPECT_NEAR(across(2), 4.0, 1e-3);
    EXPECT_NEAR(across(3), 4.0, 1e-3);
}

TEST(CastShadow, OfARoundSurfaceIsNotThatOfItsCornersOnItself) {
    const Placement ring = place(analytic::torus({.n = 48}).mesh, dmat4(1.0), 1);
    const Lines found = shadows_of({ring, floor_at(-3.0)}, {sun({0.6, 0.1, 1})});
    EXPECT_TRUE(found.on(0).empty()) << length(found.on(0));
    EXPECT_FALSE(found.on(1).empty());
}

TEST(CastShadow, IsNoneWhereABodyStandsOnAnotherAndNoneBehindThat) {
    const Lines found =
        shadows_of({place(box(), moved({0, 0, 1}), 1), floor_at(0.0, 2), floor_at(-5.0, 3)}, {sun(slanted)});
    EXPECT_FALSE(found.on(1).empty());
    for (const Segment& s : found.on(2))
        EXPECT_GT(std::abs(s.middle().x) + std::abs(s.middle().y), 10.0);  // of the floor
    for (const Segment& s : found.on(1)) {
        const dvec3 middle = s.middle();
        EXPECT_FALSE(std::max(std::abs(middle.x), std::abs(middle.y)) < 0.999) << "below the box";
    }
}

TEST(CastShadow, OfALampInAClosedBoxStaysInIt) {
    const std::vector<Placement> room = {place(box({-5, -5, 0}, {5, 5, 6}), dmat4(1.0), 1),
                                         place(sphere(12), moved({0, 0, 2}), 2), floor_at(-1.0)};
    const Lines found = shadows_of(room, {lamp({0.5, 0.3, 5})});
    EXPECT_FALSE(found.on(0).empty());
    EXPECT_TRUE(found.on(2).empty());
    for (const Segment& s : found.on(0)) EXPECT_NEAR(s.a.z, 0.0, 1e-5);
}

TEST(CastShadow, MovesTurnsAndGrowsWithTheScene) {
    const std::vector<Placement> placements = {place(tumbled_torus(), moved({0, 0, 2}), 1), floor_at(0.0)};
    const Lines before = shadows_of(placements, {lamp({1, 2, 7})});
    const dmat4 motion = glm::rotate(moved({5, -3, 2}) * scaled(dvec3(2.5)), 1.1, dvec3(0.2, 1, 0.4));
    std::vector<Placement> all = placements;
    for (Placement& placement : all) placement.object_to_world = motion * placement.object_to_world;
    const Lines after = shadows_of(all, {lamp(dvec3(motion * dvec4(1, 2, 7, 1)))});
    EXPECT_EQ(before.ids.size(), after.ids.size());
    EXPECT_NEAR(length(after.segments) / length(before.segments), 2.5, 2e-3);
}

TEST(CastShadow, OfAVeryFarLampIsThatOfASun) {
    const std::vector<Placement> placements = {place(tumbled_torus(), moved({0, 0, 2}), 1), floor_at(0.0)};
    const Lines near = shadows_of(placements, {sun(slanted)}), far = shadows_of(placements, {lamp(slanted * 3e4)});
    EXPECT_NEAR(length(far.on(1)) / length(near.on(1)), 1.0, 2e-3);
}

TEST(CastShadow, IsOfTheStrongestLightsAndOfThoseThatCast) {
    const std::vector<Placement> placements = {place(box(), moved({0, 0, 3}), 1), floor_at(0.0)};
    Light silent = lamp({5, 5, 9}, 100.0f, 3);
    silent.casts = false;
    const std::vector<Light> lights = {lamp({3, 0, 9}, 1.0f, 1), lamp({-3, 0, 9}, 2.0f, 2), silent};
    const Lines both = shadows_of(placements, lights), one = shadows_of(placements, lights, {1, 0}),
                strongest = shadows_of(placements, {lights[1]});
    EXPECT_EQ(both.closed, 2u);
    EXPECT_EQ(one.closed, 1u);
    EXPECT_EQ(one.ids, strongest.ids);
    EXPECT_TRUE(shadows_of(placements, lights, {0, 0}).segments.empty());
    EXPECT_EQ(std::set(both.ids.begin(), both.ids.end()).size(), both.ids.size());
}

TEST(CastShadow, EndsWhereASpotEndsAndIsFiveForAnAreaWithCorners) {
    const std::vector<Placement> placements = {place(box({-3, -0.2f, 0}, {3, 0.2f, 0.2f}), moved({0, 0, 3}), 1),
                                               floor_at(0.0)};
    Light spot = lamp({0, 0, 6});
    spot.kind = Light::spot;
    spot.cos_outer = float(std::sqrt(0.8));  // its tangent is 1/2: on the floor a radius of 3
    const Lines lit = shadows_of(placements, {spot});
    ASSERT_FALSE(lit.on(1).empty());
    double farthest = 0.0;
    for (const Segment& s : lit.on(1))
        farthest = std::max({farthest, glm::length(dvec2(s.a)), glm::length(dvec2(s.b))});
    EXPECT_NEAR(farthest, 3.0, 1e-3);

    Light area = lamp({0, 0, 6});
    area.kind = Light::area;
    area.half_side[0] = {0.5, 0, 0};
    area.half_side[1] = {0, 0.25, 0};
    EXPECT_EQ(shadows_of(placements, {area}).closed, 1u);
    EXPECT_EQ(shadows_of(placements, {area}, {4, 1}).closed, 5u);
}

TEST(CastShadow, IsNoneOfWhatTheSectionPlaneCutsAway) {
    const std::vector<Placement> placements = {place(box(), moved({0, 0, 5}), 1), place(box(), moved({6, 0, 2}), 2),
                                               floor_at(0.0)};
    const Lines found(placements, {sun(slanted)}, line_set({"cast_shadow"}), dvec4(0, 0, 1, -3.5));
    EXPECT_EQ(found.closed, 1u);
    const Lines alone = shadows_of({placements[1], placements[2]}, {sun(slanted)});
    EXPECT_NEAR(length(found.segments), length(alone.segments), 1e-3);
}

TEST(CastShadow, OfBrokenLightsAndEmptyScenesIsNothing) {
    const std::vector<Placement> placements = {place(box(), moved({0, 0, 3}), 1), floor_at(0.0)};
    const double nan = std::numeric_limits<double>::quiet_NaN(), inf = std::numeric_limits<double>::infinity();
    for (const Light& light : {sun({nan, 0, 1}), sun({0, 0, 0}), sun({inf, 0, 0}), lamp({0, nan, 5}),
                               lamp({0, 0, 5}, 0.0f), lamp({0, 0, 5}, float(nan))})
        EXPECT_TRUE(shadows_of(placements, {light}).segments.empty());
    EXPECT_TRUE(shadows_of({}, {sun(slanted)}).segments.empty());
    EXPECT_TRUE(shadows_of(placements, {}).segments.empty());
    EXPECT_TRUE(shadows_of({floor_at(0.0)}, {sun(slanted)}).segments.empty());
    shadows_of(placements, {lamp({1, 1, 4}), lamp({1, 1, 3}), lamp({0, 0, 3})});  // at a corner, on and in the box
}
