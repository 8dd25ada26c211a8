// SPDX-License-Identifier: GPL-3.0-or-later
// The shadow of a triangle against the definition: is the point behind the triangle, as the eye sees it?
#include <gtest/gtest.h>
#include <random>

#include <fovea/scene/shadow_volume.h>

using namespace fovea;
using namespace fovea::draw;

namespace {

/// Does the ray from the eye (the origin, or along -z) to the point pass through the triangle before the point?
bool hidden(const dvec3 corners[3], bool orthographic, const dvec3& p, double margin) {
    const dvec3 origin = orthographic ? dvec3(p.x, p.y, 0.0) : dvec3(0.0), direction = p - origin;
    const dvec3 e1 = corners[1] - corners[0], e2 = corners[2] - corners[0];
    const dvec3 n = glm::cross(direction, e2);
    const double det = glm::dot(e1, n);
    const double u = glm::dot(origin - corners[0], n) / det;
    const dvec3 q = glm::cross(origin - corners[0], e1);
    const double v = glm::dot(direction, q) / det, t = glm::dot(e2, q) / det;
    return u >= 0 && v >= 0 && u + v <= 1 && t > 0 && t < 1.0 - margin;
}

View seen(bool orthographic, double near_clip) {
    View view;
    view.orthographic = orthographic;
    view.near_clip = near_clip;
    return view;
}

/// Points of segments, by whether they are hidden.
struct Points {
    int inside = 0, outside = 0;

    /// Of a segment of which `found` is said to be hidden, beside the ends of that; is_hidden(t) tells.
    template <typename IsHidden>
    void expect(const Interval& found, const IsHidden& is_hidden) {
        for (int i = 0; i <= 40; ++i) {
            const double t = i / 40.0;
            if (std::min(std::abs(t - found.begin), std::abs(t - found.end)) < 1e-6) continue;
            EXPECT_EQ(found.holds(t), is_hidden(t)) << t;
            ++(found.holds(t) ? inside : outside);
        }
    }
};

}  // namespace

TEST(ShadowVolume, IsWhereTheTriangleHides) {
    std::mt19937 random(17);
    std::uniform_real_distribution<double> side(-2, 2), deep(-8, -1);
    const auto any = [&] { return dvec3(side(random), side(random), deep(random)); };
    Points points;
    int segments = 0;
    for (int k = 0; k < 4000; ++k) {
        const bool orthographic = k % 2;
        const dvec3 corners[3] = {any(), any(), any()};
        const ShadowVolume shadow(corners, seen(orthographic, 0.5), 1e-9);
        ASSERT_TRUE(shadow.usable());
        const dvec3 a = any(), b = any();
        const Interval found = shadow.hides(a, b);
        segments += found.begin <= found.end;
        SCOPED_TRACE(k);
        points.expect(found, [&](double t) { return hidden(corners, orthographic, glm::mix(a, b, t), 1e-9); });
    }
    EXPECT_GT(points.inside, 1000);
    EXPECT_GT(points.outside, 1000);
    EXPECT_GT(segments, 200);
}

TEST(ShadowVolume, OfAQuadrilateralIsThatOfItsHalves) {
    std::mt19937 random(18);
    std::uniform_real_distribution<double> side(-2, 2), deep(-8, -1), corner(0.2, 1.0);
    const auto any = [&] { return dvec3(side(random), side(random), deep(random)); };
    int segments = 0;
    for (int k = 0; k < 4000; ++k) {
        const bool orthographic = k % 2;
        // Corners on the four half axes of a plane: flat and convex.
        const dvec3 middle = any() - dvec3(0, 0, 2), u = 2.0 * glm::normalize(any()), v = 2.0 * glm::normalize(any());
        const dvec3 quad[4] = {middle + corner(random) * u, middle + corner(random) * v, middle - corner(random) * u,
                               middle - corner(random) * v};
        const dvec3 halves[2][3] = {{quad[0], quad[1], quad[2]}, {quad[0], quad[2], quad[3]}};
        const ShadowVolume whole(quad, seen(orthographic, 0.5), 1e-9);
        ASSERT_TRUE(whole.usable());
        const dvec3 a = any(), b = any();
        const Interval found = whole.hides(a, b);
        segments += found.begin <= found.end;
        SCOPED_TRACE(k);
        Points().expect(found, [&](double t) {
            const dvec3 p = glm::mix(a, b, t);
            return hidden(halves[0], orthographic, p, 1e-9) || hidden(halves[1], orthographic, p, 1e-9);
        });
    }
    EXPECT_GT(segments, 100);
}

TEST(ShadowVolume, BeginsBehindTheTriangleByTheMargin) {
    const dvec3 corners[3] = {{-1, -1, -4}, {3, -1, -4}, {-1, 3, -4}};
    for (const bool orthographic : {false, true}) {
        const ShadowVolume shadow(corners, seen(orthographic, 0.1), 1e-2);
        // Straight away from the viewer through the triangle.
        const dvec3 a = orthographic ? dvec3(0, 0, -3) : dvec3(0.3, 0.3, -3),
                    b = orthographic ? dvec3(0, 0, -5) : a * 5.0 / 3.0;
        const Interval found = shadow.hides(a, b);
        EXPECT_EQ(found.end, 1.0);
        EXPECT_NEAR(-3 - 2 * found.begin, -4 * 1.01, orthographic ? 0.02 : 1e-9);
    }
}

TEST(ShadowVolume, SaysNothingOfTrianglesAtTheNearPlaneOrEdgeOn) {
    const dvec3 a(-1, -1, -2), b(1, -1, -2), c(0, 1, -2);
    const auto usable = [](dvec3 p, dvec3 q, dvec3 r, bool orthographic) {
        const dvec3 corners[3] = {p, q, r};
        const ShadowVolume shadow(corners, seen(orthographic, 0.5), 1e-5);
        const Interval found = shadow.hides({-3, -0.5, -3}, {3, -0.5, -3});
        EXPECT_EQ(shadow.usable(), found.begin <= found.end);
        return shadow.usable();
    };
    for (const bool orthographic : {false, true}) {
        EXPECT_TRUE(usable(a, b, c, orthographic));
        EXPECT_FALSE(usable(a, b, {0, 1, -0.4}, orthographic)) << "before the near plane";
        EXPECT_FALSE(usable(a, b, {0, 1, 3}, orthographic)) << "behind the viewer";
        EXPECT_FALSE(usable(a, a, c, orthographic)) << "no triangle";
        EXPECT_FALSE(usable({0, -1, -2}, {0, 1, -2}, {0, 1, -4}, orthographic)) << "seen edge on";
    }
    EXPECT_FALSE(ShadowVolume().usable());
    EXPECT_TRUE(ShadowVolume().hides(a, b).is_empty());
}

TEST(ShadowVolume, OfALightIsAllAroundIt) {
    std::mt19937 random(19);
    std::uniform_real_distribution<double> side(-3, 3);
    const auto any = [&] { return dvec3(side(random), side(random), side(random)); };
    Points points;
    for (int k = 0; k < 4000; ++k) {
        const dvec3 corners[3] = {any(), any(), any()}, a = any(), b = any();
        const Interval found = ShadowVolume(corners, seen(false, 0.0), 1e-9).hides(a, b);
        SCOPED_TRACE(k);
        points.expect(found, [&](double t) { return hidden(corners, false, glm::mix(a, b, t), 1e-9); });
    }
    EXPECT_GT(points.inside, 500);
    EXPECT_GT(points.outside, 1000);
}

TEST(ShadowVolume, CoversWhatIsBeforeThePolygonToo) {
    const dvec3 corners[3] = {{-1, -1, -4}, {3, -1, -4}, {-1, 3, -4}};
    for (const bool orthographic : {false, true}) {
        const ShadowVolume shadow(corners, seen(orthographic, 0.1), 1e-9);
        const dvec3 a(-2, 0, -2), b(2, 0, -2);
        EXPECT_TRUE(shadow.hides(a, b).is_empty());
        const Interval covered = shadow.covers(a, b);
        // Between the left side, and the slanted one where y is 0.
        EXPECT_NEAR(-2 + 4 * covered.begin, orthographic ? -1.0 : -0.5, 1e-9);
        EXPECT_NEAR(-2 + 4 * covered.end, orthographic ? 2.0 : 1.0, 1e-9);
    }
}
