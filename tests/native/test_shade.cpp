// SPDX-License-Identifier: GPL-3.0-or-later
// Places that are lit, in attached or in cast shadow: known in closed form, and by the outlines of shadows.
#include <gtest/gtest.h>
#include <random>

#include <fovea/scene/shade.h>

#include "analytic.h"
#include "shadows.h"

using namespace fovea;
using namespace fovea::draw;
using namespace fovea::drawing;
using namespace fovea::meshes;
using namespace fovea::shadows;

namespace {

const dvec3 slanted = glm::normalize(dvec3(0.5, -0.3, 1.0));
const dvec4 from_above(0, 0, 1, 0);

Scene lit_by(std::vector<Placement> placements, std::vector<Light> lights) {
    Scene scene(std::move(placements));
    scene.lights = std::move(lights);
    return scene;
}

Placement floor_at(double z, std::uint64_t id = 9) { return place(grid(1, 20.0f), moved({0, 0, z}), id); }

Placement smooth_sphere(int n, const dmat4& to_world = dmat4(1.0), std::uint64_t id = 1) {
    Mesh mesh = sphere(n);
    mesh.shape = Shape::smooth;
    return place(mesh, to_world, id);
}

/// The shade of a floor's point, which two triangles share.
Shade on_floor(const Shades& shades, const ShadedSurface& floor, const dvec2& at, double z = 0.0) {
    return shades.at(floor.at(at.x > at.y ? 0 : 1, dvec3(at, z)));
}

/// Random points on the triangles of a placement, evenly by triangle: visit(triangle, point in the world).
template <typename Visit>
void each_point(const Scene& scene, Index placement, int count, const Visit& visit) {
    const Surface& surface = *scene.placements[placement].surface;
    std::mt19937 random(11);
    std::uniform_real_distribution<double> share(0.0, 1.0);
    for (int n = 0; n < count; ++n) {
        const auto triangle = static_cast<Index>(random() % surface.triangles.size());
        double u = share(random), v = share(random);
        if (u + v > 1.0) u = 1.0 - u, v = 1.0 - v;
        const Triangle& t = surface.triangles[triangle];
        const dvec3 a(surface.positions[t.x]), b(surface.positions[t.y]), c(surface.positions[t.z]);
        visit(triangle, dvec3(scene.placements[placement].object_to_world * dvec4(a + u * (b - a) + v * (c - a), 1.0)));
    }
}

}  // namespace

TEST(Shade, OfASphereOnAFloorByTheSunIsAnEllipse) {
    const dvec3 c(0.3, 0.2, 2.5);
    const Scene scene = lit_by({smooth_sphere(48, moved(c)), floor_at(0.0)}, {sun(slanted)});
    const Shades shades(scene);
    const ShadedSurface floor(scene, 1, from_above);
    std::mt19937 random(3);
    std::uniform_real_distribution<double> coordinate(-4.0, 4.0);
    int dark = 0;
    for (int n = 0; n < 20000; ++n) {
        const dvec2 at(coordinate(random), coordinate(random));
        const dvec3 from = dvec3(at, 0.0) - c;
        const double passes = glm::length(from - glm::dot(from, slanted) * slanted);
        if (std::abs(passes - 1.0) < 0.01) continue;
        const Shade shade = on_floor(shades, floor, at);
        EXPECT_EQ(shade, passes < 1.0 ? Shade::cast : Shade::lit) << at.x << " " << at.y;
        dark += shade == Shade::cast;
    }
    EXPECT_GT(dark, 500);
}

TEST(Shade, OfASmoothSphereIsItsHalfAwayFromTheLight) {
    const dvec3 at(2.0, 1.0, 3.0);
    for (const int n : {8, 16, 48})
        for (const Light& light : {sun(slanted), lamp(at)}) {
            const Scene scene = lit_by({smooth_sphere(n)}, {light});
            const Shades shades(scene);
            const ShadedSurface surface(scene, 0, dvec4(3, -5, 1, 0));
            const double level = light.kind == Light::sun ? 0.0 : 1.0 / glm::length(at);
            int lit = 0;
            each_point(scene, 0, 20000, [&](Index triangle, const dvec3& point) {
                const dvec3 normal = glm::normalize(point);
                const double over = glm::dot(normal, light.kind == Light::sun ? slanted : glm::normalize(at)) - level;
                if (std::abs(over) < 0.2 / n) return;
                const Shade shade = shades.at(surface.at(triangle, point));
                // Nothing of a sphere is in the shadow of its own faces.
                EXPECT_EQ(shade, over > 0.0 ? Shade::lit : Shade::attached) << n << " " << over;
                lit += shade == Shade::lit;
            });
            EXPECT_GT(lit, 5000);
        }
}

TEST(Shade, OfACylindersFacesIsBySides) {
    // Its faces are meant as they are: each is lit as a whole, but for what the far wall hides of the near one's
    // inside.
    const Scene scene = lit_by({place(cylinder(12))}, {sun({1, 0.1, 0.05})});
    const Shades shades(scene);
    const dvec4 viewer(1, 0.1, 0.0, 0);
    const ShadedSurface surface(scene, 0, viewer);
    each_point(scene, 0, 5000, [&](Index triangle, const dvec3& point) {
        const Index facet = surface.surface().triangle_facet[triangle];
        const dvec3 outside(dvec2(surface.surface().facet_plane[facet]), 0.0);
        const bool towards = glm::dot(outside, dvec3(viewer)) > 0.0;
        const double height = point.z + 1.0;
        const Shade shade = shades.at(surface.at(triangle, point));
        // From the light's side one sees the near wall's outside, and the far wall's inside behind it: of that light
        // that comes over the near wall's upper border reaches no more than a strip.
        if (towards || height < 1.85) {
            EXPECT_EQ(shade, towards ? Shade::lit : Shade::cast);
        }
    });
}

TEST(Shade, OfALampInAClosedBoxIsItsInside) {
    const Scene scene = lit_by(
        {place(box({-5, -5, 0}, {5, 5, 6})), place(sphere(12), moved({0, 0, 2}), 2), floor_at(-1.0), floor_at(0.5, 10)},
        {lamp({0.5, 0.3, 5})});
    const Shades shades(scene);
    const ShadedSurface outside(scene, 2, from_above), inside(scene, 3, from_above);
    for (double x = -4.5; x < 5; x += 1.5) {
        EXPECT_EQ(on_floor(shades, outside, {x, 0.3}, -1.0), Shade::cast);
        EXPECT_EQ(on_floor(shades, inside, {x, 3.3}, 0.5), Shade::lit);
        EXPECT_EQ(on_floor(shades, inside, {x + 12, 0.3}, 0.5), Shade::cast);
    }
    // The solid's own outside turns its back to what is in it.
    const ShadedSurface walls(scene, 0, from_above);
    each_point(scene, 0, 500, [&](Index triangle, const dvec3& point) {
        EXPECT_EQ(shades.at(walls.at(triangle, point)), Shade::attached);
    });
}

TEST(Shade, OfRandomPointsIsWhatTheOutlinesOfShadowsSay) {
    const dmat4 tumbled = glm::rotate(moved({0, 0, 3}), 0.9, dvec3(1, 0.3, 0.2));
    const std::vector<Placement> placements = {place(analytic::torus({.n = 24}).mesh, tumbled, 1),
                                               place(box(), moved({1.5, 1, 5}) * scaled(dvec3(0.6)), 2),
                                               place(cylinder(24), moved({-2, -1, 3}) * tumbled, 3), floor_at(0.0)};
    for (const Light& light : {sun(slanted), lamp({1, -1, 12})}) {
        const Lines lines(placements, {light}, line_set_with("cast_shadow", {4, 0}));
        const std::vector<Segment> segments = lines.on(3);
        const Shades shades(lines.scene);
        const ShadedSurface floor(lines.scene, 3, from_above);
        const double half = 8.0, cell = 0.08;
        const int cells = int(2 * half / cell);
        // Rows of points; along each the number of outlines before a point.
        int wrong = 0, dark = 0, counted = 0;
        std::mt19937 random(5);
        std::uniform_real_distribution<double> share(0.0, 1.0);
        for (int row = 0; row < 500; ++row) {
            const double y = -half + 2 * half * (row + share(random)) / 500;
            std::vector<double> crossings;
            std::vector<std::uint8_t> near(cells, 0);
            for (const Segment& s : segments) {
                const auto column = [&](double x) { return int(std::clamp((x + half) / cell, 0.0, cells - 1.0)); };
                if (std::min(s.a.y, s.b.y) < y + 0.01 && std::max(s.a.y, s.b.y) > y - 0.01)
                    for (int i = column(std::min(s.a.x, s.b.x) - cell); i <= column(std::max(s.a.x, s.b.x) + cell); ++i)
                        near[i] = std::min(std::abs(s.a.x - s.b.x), 1.0) > 0.0;
                if ((s.a.y < y) != (s.b.y < y))
                    crossings.push_back(glm::mix(s.a.x, s.b.x, (y - s.a.y) / (s.b.y - s.a.y)));
            }
            for (int n = 0; n < 200; ++n) {
                const double x = -half + 2 * half * share(random);
                if (near[int((x + half) / cell)]) continue;
                const auto before = std::ranges::count_if(crossings, [&](double c) { return c < x; });
                const Shade shade = on_floor(shades, floor, {x, y});
                ++counted;
                dark += shade == Shade::cast;
                wrong += (shade == Shade::cast) != (before % 2 == 1);
            }
        }
        EXPECT_GT(counted, 50000);
        EXPECT_GT(dark, counted / 50);
        EXPECT_EQ(wrong, 0) << "of " << counted;
    }
}

TEST(Shade, EndsWithTheConeOfASpotAndBehindAnArea) {
    Light spot = lamp({0, 0, 6});
    spot.kind = Light::spot;
    spot.cos_outer = float(std::sqrt(0.8));  // its tangent is 1/2: on the floor a radius of 3
    Light area = spot;
    area.kind = Light::area;
    area.direction = {1, 0, 0};
    area.half_side[0] = {0, 0.5, 0};
    area.half_side[1] = {0, 0, 0.5};
    const Scene in_cone = lit_by({floor_at(0.0)}, {spot}), beside = lit_by({floor_at(0.0)}, {area});
    const Shades of_spot(in_cone), of_area(beside);
    const ShadedSurface floor(in_cone, 0, from_above), same(beside, 0, from_above);
    for (double angle = 0.1; angle < 6.0; angle += 0.37) {
        const dvec2 way(std::cos(angle), std::sin(angle));
        EXPECT_EQ(on_floor(of_spot, floor, 2.99 * way), Shade::lit);
        EXPECT_EQ(on_floor(of_spot, floor, 3.01 * way), Shade::cast);
        EXPECT_EQ(on_floor(of_area, same, way), way.x > 0.0 ? Shade::lit : Shade::cast);
    }
}

TEST(Shade, IsOfTheSideThatOneLooksAt) {
    // A sheet, lit from above, from below; what stands on it keeps its foot dark.
    const Scene scene = lit_by({floor_at(0.0), place(box(), moved({0, 0, 1}), 2)}, {sun({0, 0, 1})});
    const Shades shades(scene);
    const ShadedSurface above(scene, 0, from_above), below(scene, 0, -from_above);
    EXPECT_EQ(on_floor(shades, above, {3, 1}), Shade::lit);
    EXPECT_EQ(on_floor(shades, below, {3, 1}), Shade::attached);
    EXPECT_EQ(on_floor(shades, above, {0.3, 0.1}), Shade::cast);
    // Walls along the light are behind it, whatever rounding says.
    const ShadedSurface cube(scene, 1, from_above);
    each_point(scene, 1, 500, [&](Index triangle, const dvec3& point) {
        const dvec3 normal = cube.facet_normal(cube.surface().triangle_facet[triangle]);
        EXPECT_EQ(shades.at(cube.at(triangle, point)), normal.z > 0.5 ? Shade::lit : Shade::attached);
    });
}

TEST(Shade, OfSeveralLightsIsLitWhereOneShines) {
    const Scene scene = lit_by({floor_at(0.0), place(box(), moved({0, 0, 1.3}), 2)},
                               {lamp({8, 0, 8}, 2.0f, 1), lamp({-8, 0, 8}, 1.0f, 2)});
    const Shades both(scene), strongest(scene, 1), no_light(scene, 0);
    ASSERT_EQ(both.count(), 2u);
    EXPECT_EQ(both.light(0).id, 1u);
    const ShadedSurface floor(scene, 0, from_above);
    for (double x = -6; x < 6; x += 0.25) {
        const ShadedPlace place = floor.at(x > 0.1 ? 0 : 1, {x, 0.1, 0});
        const bool lit = both.by(0, place) == Shade::lit || both.by(1, place) == Shade::lit;
        EXPECT_EQ(both.at(place) == Shade::lit, lit);
        EXPECT_EQ(strongest.at(place), both.by(0, place));
        EXPECT_EQ(no_light.at(place), Shade::lit);
    }
    EXPECT_EQ(both.at(floor.at(0, {0.3, 0.1, 0})), Shade::cast);
    EXPECT_EQ(both.at(floor.at(0, {3.5, 0.1, 0})), Shade::lit);
    EXPECT_EQ(both.by(1, floor.at(0, {3.5, 0.1, 0})), Shade::cast);
}

TEST(Shade, MovesTurnsAndGrowsWithTheScene) {
    const std::vector<Placement> placements = {place(analytic::torus({.n = 24}).mesh, moved({0, 0, 2}), 1),
                                               floor_at(0.0)};
    std::vector<Placement> turned = placements;
    const dmat4 motion = glm::rotate(moved({5, -3, 2}) * scaled(dvec3(2.5)), 1.1, dvec3(0.2, 1, 0.4));
    for (Placement& placement : turned) placement.object_to_world = motion * placement.object_to_world;
    const Scene before = lit_by(placements, {lamp({1, 2, 7})}),
                after = lit_by(turned, {lamp(dvec3(motion * dvec4(1, 2, 7, 1)))});
    const Shades of_before(before), of_after(after);
    for (const Index i : {0u, 1u}) {
        const ShadedSurface here(before, i, from_above), there(after, i, motion * from_above);
        int differ = 0;
        each_point(before, i, 5000, [&](Index triangle, const dvec3& point) {
            differ += of_before.at(here.at(triangle, point)) !=
                      of_after.at(there.at(triangle, dvec3(motion * dvec4(point, 1.0))));
        });
        EXPECT_LE(differ, 2);
    }
}

TEST(Shade, OfManyPlacesIsThatOfEach) {
    const Scene scene = lit_by({smooth_sphere(16, moved({0, 0, 2})), floor_at(0.0)}, {sun(slanted)});
    const Shades shades(scene);
    const ShadedSurface floor(scene, 1, from_above);
    std::vector<ShadedPlace> places;
    each_point(scene, 1, 3000, [&](Index t, const dvec3& point) { places.push_back(floor.at(t, 0.2 * point)); });
    const Array<Shade> all = shades.at(places);
    for (std::size_t i = 0; i < places.size(); ++i) EXPECT_EQ(all[i], shades.at(places[i]));
}

TEST(Shade, OfBrokenPlacesAndLightsIsSomething) {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    const Scene scene = lit_by({floor_at(0.0), place(box())}, {lamp({0, 0, 3}), sun({nan, 0, 1})});
    const Shades shades(scene);
    EXPECT_EQ(shades.count(), 1u);
    const ShadedSurface floor(scene, 0, from_above);
    EXPECT_EQ(shades.at(floor.at(0, dvec3(nan))), Shade::cast);
    EXPECT_EQ(shades.at(floor.without_facet({0, 0, 3})), Shade::lit);  // at the lamp
    EXPECT_TRUE(shades.at(In<ShadedPlace>()).empty());
}
