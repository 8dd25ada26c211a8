// SPDX-License-Identifier: GPL-3.0-or-later
// Rays against spheres and planes, whose answers are known; the depth pass and the holes of holdouts.
#include <gtest/gtest.h>
#include <random>

#include <fovea/scene/light_view.h>
#include <fovea/scene/seen.h>
#include <fovea/scene/tracer.h>
#include <fovea/visibility/depth.h>
#include <fovea/visibility/depth_image.h>

#include "drawing.h"

using namespace fovea;
using namespace fovea::draw;
using namespace fovea::meshes;
using namespace fovea::drawing;

namespace {

const Ignore nothing;

/// Distance along a ray (unit direction) to the unit sphere around `center`; negative: missed.
double to_sphere(dvec3 origin, dvec3 direction, dvec3 center) {
    const double b = glm::dot(direction, center - origin), c = glm::dot(center - origin, center - origin) - 1.0;
    return b * b < c ? -1.0 : b - std::sqrt(b * b - c);
}

vec3 in_view(const View& view, dvec3 world) { return vec3(view.world_to_view * dvec4(world, 1.0)); }

}  // namespace

TEST(Tracer, SeesASphereWhereItIs) {
    const Scene scene({place(sphere(64), moved({0.3, 0, 0}))});
    const dvec3 eye(0, -6, 0);
    const View view = perspective(eye, {0, 0, 0});
    const Tracer tracer(scene, view);
    int seen = 0;
    for (int y = 5; y < 480; y += 23)
        for (int x = 5; x < 640; x += 31) {
            const dvec2 px(x + 0.5, y + 0.5);
            const dvec3 direction = glm::normalize(dvec3((px.x / 320 - 1) * 0.36, 1.0, (px.y / 240 - 1) * 0.27));
            const double expected = to_sphere(eye, direction, {0.3, 0, 0});
            const double beside = glm::length(glm::cross(dvec3(0.3, 6, 0), direction));  // the ray passes the center at
            if (std::abs(beside - 1.0) < 0.01) continue;
            const auto hit = tracer.seen(px);
            ASSERT_EQ(hit.has_value(), expected > 0.0) << x << " " << y;
            if (!hit) continue;
            EXPECT_NEAR(hit->t, expected * direction.y, 0.01 / (1.01 - beside)) << "distance along the view";
            ++seen;
        }
    EXPECT_GT(seen, 20);
}

TEST(Tracer, OccluderIsTheNearestThatHides) {
    const Scene scene({place(grid(1), moved({0, 0, -3})), place(grid(1), moved({0, 0, -5}), 2),
                       place(grid(1), moved({0, 0, -7}), 3)});
    for (const bool ortho : {false, true}) {
        const View view = ortho ? orthographic({0, 0, 0}, {0, 0, -1}, 4) : perspective({0, 0, 0}, {0, 0, -1}, 36);
        const Tracer tracer(scene, view);
        const auto hides = [&](double z) {
            const auto hit = tracer.occluder(in_view(view, {0.1, 0.2, z}), nothing);
            return hit ? int(hit->placement) : -1;
        };
        EXPECT_EQ(hides(-2), -1);
        EXPECT_EQ(hides(-3), -1) << "on the first";
        EXPECT_EQ(hides(-4), 0);
        EXPECT_EQ(hides(-5), 0) << "on the second, behind the first";
        EXPECT_EQ(hides(-9), 0);
        EXPECT_NEAR(tracer.occluder(in_view(view, {0.1, 0.2, -6}), nothing)->t, ortho ? (3 - 0.1) / (6 - 0.1) : 0.5,
                    1e-5);
        const auto behind = [&](double z) {
            const auto hit = tracer.behind(in_view(view, {0.1, 0.2, z}), nothing);
            return hit ? int(hit->placement) : -1;
        };
        EXPECT_EQ(behind(-2), 0);
        EXPECT_EQ(behind(-3), 1);
        EXPECT_EQ(behind(-6), 2);
        EXPECT_EQ(behind(-7), -1);
    }
}

TEST(Tracer, RaysMeetTheSameOfASurfaceAloneAndWithAnotherBesideThem) {
    const Placement ball = place(sphere(12), moved({0.1, 0.2, -6}) * scaled({1.0, 0.7, 1.2}));
    const dvec3 corner(-2.7, -2.0, -6.0);
    const Scene alone({ball}), both({ball, place(box(), moved(corner) * scaled(dvec3(0.05)), 2)});
    for (const bool ortho : {false, true}) {
        const View view = ortho ? orthographic({0, 0, 0}, {0, 0, -1}, 6) : perspective({0, 0, 0}, {0, 0, -1}, 36);
        const Tracer one(alone, view), other(both, view);
        const auto in_corner = other.occluder(in_view(view, ortho ? corner - dvec3(0, 0, 3) : 1.5 * corner), nothing);
        ASSERT_TRUE(in_corner && in_corner->placement == 1) << "rays do meet the other one";
        std::mt19937 random(53);
        std::uniform_real_distribution<double> share(-1.0, 1.0);
        int hidden = 0, seen = 0;
        for (int n = 0; n < 2000; ++n) {
            const dvec3 world(1.2 * share(random), 1.2 * share(random), -6.0 + 3.0 * share(random));
            const vec3 point = in_view(view, world);
            const auto hit = one.occluder(point, nothing), beyond = one.behind(point, nothing);
            const auto same = [](const std::optional<Hit>& a, const std::optional<Hit>& b) {
                return a.has_value() == b.has_value() &&
                       (!a || (a->placement == b->placement && a->triangle == b->triangle && a->t == b->t));
            };
            EXPECT_TRUE(same(hit, other.occluder(point, nothing))) << n;
            EXPECT_TRUE(same(beyond, other.behind(point, nothing))) << n;
            hidden += hit.has_value();
            seen += beyond.has_value();
            if (ortho) continue;
            scene::Blocker last, last_of_other;
            EXPECT_EQ(one.is_blocked(dvec3(0.0), point, 1.0, nothing, last),
                      other.is_blocked(dvec3(0.0), point, 1.0, nothing, last_of_other))
                << n;
        }
        EXPECT_GT(hidden, 200);
        EXPECT_GT(seen, 200);
    }
}

TEST(Tracer, ContinuesBehindIsWhetherTheNearestSurfaceBehindIsOfTheSameOutline) {
    std::vector<Placement> placements;
    const auto small = box().surface(), large = sphere(16).surface();
    for (int i = 0; i < 40; ++i) {
        const dvec3 middle(2 * std::sin(3.1 * i), 2 * std::cos(1.7 * i), -8 + 3 * std::sin(2.3 * i));
        placements.push_back({i % 2 ? small : large, moved(middle), std::uint64_t(i + 1)});
        if (i % 4 == 0) placements.back().group = 1 + i % 3;
        if (i % 11 == 0) placements.back().usage = usage_draw;
    }
    const Scene scene(placements);
    for (const bool ortho : {false, true}) {
        const View view = ortho ? orthographic({0, 0, 0}, {0, 0, -1}, 9) : perspective({0, 0, 0}, {0, 0, -1}, 36);
        const Tracer tracer(scene, view);
        int yes = 0, no = 0;
        for (Index own = 0; own < scene.placements.size(); ++own)
            for (int k = 0; k < 60; ++k) {
                const dvec3 point(2.5 * std::sin(1.3 * k), 2.5 * std::cos(2.9 * k), -4 - k % 9);
                const auto behind = tracer.behind(in_view(view, point), nothing);
                const bool expected = behind && scene.share_outline(behind->placement, own);
                ASSERT_EQ(tracer.continues_behind(in_view(view, point), nothing, own), expected) << own << " " << k;
                ++(expected ? yes : no);
            }
        EXPECT_GT(yes, 20);
        EXPECT_GT(no, 1000);
    }
}

TEST(Tracer, AWayIsBlockedWhereSomethingIsMetOnItWhateverWasInTheWayOfAnother) {
    std::mt19937 random(31);
    std::uniform_real_distribution<double> side(-3.0, 3.0), size(0.2, 1.0);
    std::vector<Placement> placements;
    for (int i = 0; i < 30; ++i)
        placements.push_back(place(i % 2 ? sphere(5) : grid(2),
                                   glm::scale(moved({side(random), side(random), side(random) - 9.0}),
                                              dvec3(size(random), size(random), size(random))),
                                   std::uint64_t(i)));
    const Scene scene(std::move(placements));
    const Tracer tracer(scene, perspective({0, 0, 0}, {0, 0, -1}, 60));
    scene::Blocker last;
    int blocked = 0, ignored = 0;
    for (int n = 0; n < 5000; ++n) {
        const dvec3 point(side(random), side(random), side(random) - 9.0);
        const auto hit = tracer.along(point, nothing);
        EXPECT_EQ(tracer.is_blocked(dvec3(0.0), point, 1.0, nothing, last), hit && hit->t < 1.0) << n;
        if (!hit || !(hit->t < 1.0)) continue;
        ++blocked;
        EXPECT_FALSE(tracer.is_blocked(dvec3(0.0), point, hit->t, nothing, last)) << "before it, there is nothing";
        const Ignore facet{.placement = hit->placement,
                           .facet = scene.placements[hit->placement].surface->triangle_facet[hit->triangle]};
        const auto next = tracer.along(point, facet);
        EXPECT_EQ(tracer.is_blocked(dvec3(0.0), point, 1.0, facet, last), next && next->t < 1.0) << n;
        ignored += !next || !(next->t < 1.0);
    }
    EXPECT_GT(blocked, 500);
    EXPECT_GT(ignored, 100);
}

TEST(Tracer, WaysFromFarAwayAreBlockedByASmallThingBesideALight) {
    const Scene scene(
        {place(grid(1), moved({0, 0, -0.02}) * scaled(dvec3(0.01)), 1), place(box(), moved({0, 0, -5}), 2)});
    const Light lamp{.kind = Light::point, .position = dvec3(0.0)};
    const View view = view_from(lamp, scene);
    const Tracer tracer(scene, view);
    std::mt19937 random(37);
    std::uniform_real_distribution<double> share(-1.0, 1.0);
    int wrong = 0;
    for (int n = 0; n < 2000; ++n) {
        const dvec3 on(0.01 - 1e-6 * (1.0 + share(random)), 0.009 * share(random), -0.02);
        const dvec3 way = 150.0 * glm::normalize(dvec3(share(random), share(random), 1.5 + share(random)));
        const auto seen = [&](const dvec3& p) { return dvec3(view.world_to_view * dvec4(p, 1.0)); };
        scene::Blocker none_before;
        wrong += !tracer.is_blocked(seen(on + way), seen(on - 0.001 * way), 1.0, nothing, none_before);
    }
    EXPECT_EQ(wrong, 0);
}

TEST(Tracer, IgnoredFacetsLetTheRayThrough) {
    const Scene scene({place(grid(2), moved({0, 0, -3})), place(grid(2), moved({0, 0, -3.5}), 2)});
    const View view = perspective({0, 0, 0}, {0, 0, -1}, 36);
    const Tracer tracer(scene, view);
    const vec3 point(0.3f, 0.3f, -9.0f);  // through polygon 3 of either grid
    ASSERT_EQ(tracer.occluder(point, nothing)->placement, 0u);
    EXPECT_EQ(scene.placements[0].surface->triangle_facet[tracer.occluder(point, nothing)->triangle], 3u);
    const EdgeSide sides[] = {EdgeSide(1, true), EdgeSide(3, false)};
    EXPECT_EQ(tracer.occluder(point, {0, sides, sides + 1})->placement, 0u) << "another facet";
    EXPECT_EQ(tracer.occluder(point, {0, sides, sides + 2})->placement, 1u);
    EXPECT_EQ(tracer.occluder(point, {1, sides, sides + 2})->placement, 0u) << "of the other placement";
}

TEST(Tracer, CornersAreWhereThePlacementPutsThem) {
    const Scene scene({place(bent_quad(0), moved({-0.5, -0.5, -4}) * scaled({1, -1, 2}) * moved({0, -1, 0}))});
    const View view = perspective({0, 0, 0}, {0, 0, -1}, 36);
    const Tracer tracer(scene, view);
    const auto hit = tracer.seen(pixel_of(view, {0.1, 0.2, -4}));
    ASSERT_TRUE(hit.has_value());
    EXPECT_NEAR(hit->t, 4.0f, 1e-5f);
    const Outline outline = tracer.outline(*hit);
    EXPECT_EQ(outline.count, 4) << "both triangles of the flat quad";
    for (const dvec3& corner : In<dvec3>(outline.corners).first(outline.count)) {
        EXPECT_NEAR(std::abs(corner.x), 0.5, 1e-12);
        EXPECT_NEAR(std::abs(corner.y), 0.5, 1e-12);
        EXPECT_NEAR(corner.z, -4.0, 1e-12);
    }
}

TEST(Tracer, OnlyFlatConvexPairsOfTrianglesAreOneOutline) {
    const View view = perspective({0, 0, 0}, {0, 0, -1}, 36);
    const auto count = [&](const Mesh& mesh, dvec3 at) {
        const Scene scene({place(mesh, moved({-0.5, -0.5, -4}))});
        const Tracer tracer(scene, view);
        return tracer.outline(tracer.seen(pixel_of(view, at)).value()).count;
    };
    Mesh quad = bent_quad(0);
    EXPECT_EQ(count(quad, {0.1, 0.2, -4}), 4);
    EXPECT_EQ(count(bent_quad(0.2f), {0.1, 0.2, -4}), 3) << "bent";
    quad.positions[2] = vec3(0.45f, 0.45f, 0);
    EXPECT_EQ(count(quad, {-0.2, -0.1, -4}), 3) << "concave";
    quad.positions[2] = quad.positions[1] + quad.positions[3] - quad.positions[0];
    quad.positions[2].z = 1e-3f;
    EXPECT_EQ(count(quad, {0.1, 0.2, -4}), 3) << "flat enough for a facet, not for a shadow";
}

TEST(Tracer, TheNearPlaneCutsAway) {
    const Scene scene({place(grid(1), moved({0, 0, -0.5})), place(grid(1), moved({0, 0, -2}), 2)});
    for (const bool ortho : {false, true}) {
        const View base = ortho ? orthographic({0, 0, 0}, {0, 0, -1}, 1) : perspective({0, 0, 0}, {0, 0, -1}, 36);
        const Tracer near_tracer(scene, with_near(base, 0.4)), far_tracer(scene, with_near(base, 0.6));
        EXPECT_EQ(near_tracer.seen({321, 241})->placement, 0u);
        EXPECT_EQ(far_tracer.seen({321, 241})->placement, 1u);
        EXPECT_EQ(near_tracer.occluder({0, 0, -1.5}, nothing)->placement, 0u);
        EXPECT_FALSE(far_tracer.occluder({0, 0, -1.5}, nothing).has_value());
        EXPECT_FALSE(far_tracer.occluder({0, 0, -0.6f}, nothing).has_value()) << "a point on the near plane";
        EXPECT_FALSE(far_tracer.occluder({0, 0, -0.2f}, nothing).has_value()) << "and one before it";
    }
}

TEST(Tracer, AViewKeepsItsDistanceToHugeAndTinyObjects) {
    for (const double unit : {1e-4, 1.0, 1e4}) {
        const Scene scene({place(sphere(48), scaled(dvec3(unit)))});
        View view = perspective({0, -6 * unit, 0}, {0, 0, 0});
        view.far_clip *= unit;
        view = with_near(view, 0.1 * unit);
        const auto hit = Tracer(scene, view).seen({320.5, 240.5});
        ASSERT_TRUE(hit.has_value());
        EXPECT_NEAR(hit->t / unit, 5.0, 0.01);
    }
}

TEST(Seen, DepthIsTheDistanceAlongTheView) {
    const Scene scene({place(grid(1), moved({0, 0, -4}) * scaled({1, 2, 1}))});
    for (const bool ortho : {false, true}) {
        const View view =
            ortho ? orthographic({0, 0, 0}, {0, 0, -1}, 8, 64, 48) : perspective({0, 0, 0}, {0, 0, -1}, 18, 64, 48);
        const Tracer tracer(scene, view);
        const Array<float> depth = depth_image(tracer, Cancel());
        ASSERT_EQ(depth.size(), 64u * 48u);
        // The frame is 8 x 6 at distance 4; the grid spans the quarter of its width, and two thirds of its height.
        for (int y = 0; y < 48; ++y)
            for (int x = 0; x < 64; ++x) {
                const bool inside = x >= 24 && x < 40 && y >= 8 && y < 40;
                const float expected = inside ? 4.0f : background_depth;
                EXPECT_NEAR(depth[64 * y + x], expected, 1e-5f) << x << " " << y;
            }
    }
}

TEST(Seen, DepthIsWhatARayThroughThePixelsCenterMeets) {
    // Crossing bodies, one of them mirrored, a sheet, and a floor on which the camera stands.
    const Placement ball = place(sphere(20), scaled({-1.3, 1, 1}), 1), crate = place(box(), moved({0.8, 0.3, 0.2}), 2),
                    sheet = place(grid(5), moved({-1, 1, 0.5}) * scaled(dvec3(2)), 3),
                    floor = place(grid(3), moved({0, 0, -1}) * scaled(dvec3(60)), 4);
    const Scene scene({ball, crate, sheet, floor});
    for (const bool ortho : {false, true}) {
        const View view =
            ortho ? orthographic({4, -5, 3}, {0, 0, 0}, 8, 320, 240) : perspective({4, -5, 3}, {0, 0, 0}, 30, 320, 240);
        const Tracer tracer(scene, view);
        const Array<float> depth = depth_image(tracer, Cancel());
        int differing = 0, hits = 0;
        for (int y = 0; y < 240; ++y)
            for (int x = 0; x < 320; ++x) {
                const auto hit = tracer.seen({x + 0.5, y + 0.5});
                const float traced = hit ? hit->t : background_depth;
                differing += std::abs(depth[320 * y + x] - traced) > 2e-5f * traced;
                hits += hit.has_value();
            }
        EXPECT_GT(hits, 30000);
        EXPECT_LE(differing, 2);  // centers that lie on an edge to the last bits
    }
}

TEST(Seen, DepthIsThatOfTheDepthBufferToTheLastBit) {
    // Triangles of half a pixel, of several pixels and of many, some through the near plane.
    const Scene scene({place(sphere(200), moved({-1.2, 0, 0})), place(sphere(24), moved({1.2, 0, 0}), 2),
                       place(grid(1), moved({0, 0, -1.2}) * scaled({30, 30, 1}), 3),
                       place(sphere(60), moved({0, -9, 1}) * scaled(dvec3(0.7)), 4)});
    const View view = perspective({0.3, -9, 1}, {0, 0, 0}, 40, 157, 91);
    const Array<float> depth = depth_image(Tracer(scene, view), Cancel());
    const DepthBuffer buffer =
        draw_depth(depth_layout(view, {.scale = 1, .margin = 0.0}), view, depth_meshes(scene, view, 0.0));
    for (std::size_t i = 0; i < depth.size(); ++i) {
        const DepthTexel& texel = buffer.texels[i];
        const float expected =
            texel.facet == none ? background_depth : static_cast<float>(view.near_clip / texel.depth);
        ASSERT_EQ(depth[i], std::min(expected, background_depth)) << i;
    }
}

TEST(Seen, DepthOfACrowdIsWhatRaysMeetInAnyOrder) {
    // Boxes behind boxes, in an image of no whole number of tiles: most are left out when near ones come first.
    std::vector<Placement> near_first;
    for (int i = 0; i < 4000; ++i) {
        const double turn = 2.399963 * i, away = 0.004 * i;
        near_first.push_back(
            place(box(), moved({3 * std::cos(turn), away, 2 * std::sin(turn)}) * scaled(dvec3(0.25)), i + 1));
    }
    const std::vector<Placement> far_first(near_first.rbegin(), near_first.rend());
    for (const bool ortho : {false, true}) {
        const View view = ortho ? orthographic({0.3, -9, 1}, {0, 0, 0}, 5, 203, 117)
                                : perspective({0.3, -9, 1}, {0, 0, 0}, 40, 203, 117);
        const Scene scene(near_first), turned_round(far_first);
        const Tracer tracer(scene, view);
        const Array<float> depth = depth_image(tracer, Cancel());
        EXPECT_EQ(depth, depth_image(Tracer(turned_round, view), Cancel()));
        int differing = 0;
        for (int y = 0; y < view.height; ++y)
            for (int x = 0; x < view.width; ++x) {
                const auto hit = tracer.seen({x + 0.5, y + 0.5});
                const float traced = hit ? hit->t : background_depth;
                differing += std::abs(depth[view.width * y + x] - traced) > 2e-5f * traced;
            }
        EXPECT_LE(differing, 2);
    }
}

TEST(Seen, HoldoutsCutTheirShareOfThePixels) {
    const Placement hole = place(grid(1), moved({0, 0, -4}), 1, usage_holdout);
    const View view = perspective({0, 0, 0}, {0, 0, -1}, 18, 64, 48);
    EXPECT_TRUE(holdout_image(Tracer(Scene({place(grid(1))}), view), Cancel()).empty());
    const Scene alone({hole});
    const Array<float> cut = holdout_image(Tracer(alone, view), Cancel());
    ASSERT_EQ(cut.size(), 64u * 48u);
    double sum = 0.0;
    for (float share : cut) sum += share;
    EXPECT_NEAR(sum, 16.0 * 16.0, 1e-3);
    // A box before it covers a quarter; what lies behind it makes no difference.
    const Scene covered(
        {hole, place(grid(1), moved({0.25, 0.25, -2}) * scaled(dvec3(0.25)), 2), place(grid(1), moved({0, 0, -9}), 3)});
    sum = 0.0;
    for (float share : holdout_image(Tracer(covered, view), Cancel())) sum += share;
    EXPECT_NEAR(sum, 16.0 * 16.0 * 0.75, 1e-3);
}

TEST(Seen, CanBeCancelled) {
    const Scene scene({place(box())});
    const Tracer tracer(scene, perspective({4, -5, 3}, {0, 0, 0}));
    Cancel cancel;
    cancel.requested = true;
    EXPECT_THROW(depth_image(tracer, cancel), Cancelled);
}
