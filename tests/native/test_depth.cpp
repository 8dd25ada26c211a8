// SPDX-License-Identifier: GPL-3.0-or-later
#include <cstring>
#include <glm/gtc/matrix_transform.hpp>
#include <gtest/gtest.h>
#include <mutex>
#include <random>
#include <set>
#include <tbb/global_control.h>

#include <fovea/visibility/depth.h>

#include "meshes.h"

using namespace fovea;
using namespace fovea::draw;

namespace {

View near_view(int width, int height) {
    View view;
    view.width = width;
    view.height = height;
    view.near_clip = 0.5;
    view.far_clip = 100.0;
    view.view_to_clip = glm::perspective(1.0, double(width) / height, view.near_clip, view.far_clip);
    return view;
}

View parallel_view(int width, int height) {
    View view = near_view(width, height);
    view.orthographic = true;
    view.view_to_clip = glm::ortho(-1.0, 1.0, -1.0, 1.0, view.near_clip, view.far_clip);
    return view;
}

/// Triangles that own their arrays, one facet each.
struct TriangleSoup {
    std::vector<vec3> positions;
    std::vector<glm::uvec3> triangles;
    std::vector<Index> facets;
    Index facet_base = 0;

    void add(vec3 a, vec3 b, vec3 c) {
        const Index n = Index(positions.size());
        positions.insert(positions.end(), {a, b, c});
        triangles.push_back({n, n + 1, n + 2});
        facets.push_back(Index(facets.size()));
    }
    void add(vec3 a, vec3 b, vec3 c, vec3 d) {
        add(a, b, c);
        add(a, c, d);
    }
    operator RasterMesh() const { return {positions, triangles, facets, dmat4(1.0), facet_base}; }
};

DepthBuffer depth_of(const View& view, const std::vector<RasterMesh>& meshes, int scale = 1) {
    return draw_depth(depth_layout(view, {.scale = scale, .margin = 0.0}), view, meshes);
}

/// Depth of the plane n.x = d at a pixel position, from the ray through it.
double plane_depth(const View& view, dvec3 n, double d, dvec2 px) {
    const dvec2 ndc(px.x / view.width * 2 - 1, px.y / view.height * 2 - 1);
    const dvec4 near_h = glm::inverse(view.view_to_clip) * dvec4(ndc, -1, 1);
    const dvec4 far_h = glm::inverse(view.view_to_clip) * dvec4(ndc, 1, 1);
    const dvec3 a = dvec3(near_h) / near_h.w, b = dvec3(far_h) / far_h.w;
    const double t = (d - glm::dot(n, a)) / glm::dot(n, b - a);
    return screen_depth(view, glm::mix(a, b, t).z);
}

void expect_plane(const View& view, int scale) {
    // z = -5 + .2 x + .1 y, a quad that fills the frame.
    const auto point = [](float x, float y) { return vec3(x, y, -5.0f + 0.2f * x + 0.1f * y); };
    TriangleSoup mesh;
    mesh.add(point(-8, -8), point(8, -8), point(8, 8), point(-8, 8));
    const DepthBuffer buffer = depth_of(view, {mesh}, scale);
    ASSERT_EQ(buffer.width, view.width * scale);
    const dvec3 n(-0.2, -0.1, 1.0);
    for (int y = 0; y < buffer.height; ++y)
        for (int x = 0; x < buffer.width; ++x) {
            const DepthTexel& texel = buffer.at(x, y);
            const dvec2 px((x + 0.5) / scale, (y + 0.5) / scale);
            ASSERT_NE(texel.facet, none);
            const double here = plane_depth(view, n, -5.0, px);
            EXPECT_NEAR(texel.depth, here, 1e-6);
            EXPECT_NEAR(texel.ddx, plane_depth(view, n, -5.0, px + dvec2(1, 0)) - here, 1e-7);
            EXPECT_NEAR(texel.ddy, plane_depth(view, n, -5.0, px + dvec2(0, 1)) - here, 1e-7);
        }
}

TriangleSoup random_triangles(int count, unsigned seed) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<float> unit(-1.0f, 1.0f);
    TriangleSoup mesh;
    for (int i = 0; i < count; ++i) {
        const vec3 center{4 * unit(random), 3 * unit(random), -4.0f + 4 * unit(random)};
        const auto corner = [&] { return center + vec3{unit(random), unit(random), unit(random)}; };
        const vec3 a = corner(), b = corner(), c = corner();
        mesh.add(a, b, c);
    }
    return mesh;
}

bool same(const DepthBuffer& a, const DepthBuffer& b) {
    return a.texels.size() == b.texels.size() &&
           std::memcmp(a.texels.data(), b.texels.data(), a.texels.size() * sizeof(DepthTexel)) == 0;
}

}  // namespace

TEST(Depth, PlaneInPerspective) {
    expect_plane(near_view(40, 30), 1);
    expect_plane(near_view(40, 30), 2);
}

TEST(Depth, PlaneInOrthographicView) {
    expect_plane(parallel_view(40, 30), 1);
    expect_plane(parallel_view(40, 30), 2);
}

TEST(Depth, EmptySceneIsBackground) {
    const DepthBuffer buffer = depth_of(near_view(8, 8), {});
    for (const auto& texel : buffer.texels) {
        EXPECT_EQ(texel.facet, none);
        EXPECT_EQ(texel.depth, 0.0f);
    }
}

TEST(Depth, BothSidesAreDrawnAndNeighborsLeaveNoGap) {
    TriangleSoup mesh;
    mesh.add(vec3(-9, -9, -5), vec3(9, -9, -5), vec3(9, 9, -5));
    mesh.add(vec3(-9, -9, -5), vec3(-9, 9, -5), vec3(9, 9, -5));  // wound the other way
    for (const auto& texel : depth_of(near_view(64, 64), {mesh}).texels) EXPECT_NE(texel.facet, none);
}

TEST(Depth, NearestWinsInAnyOrder) {
    TriangleSoup near, far;
    near.add(vec3(-9, -9, -3), vec3(9, -9, -3), vec3(0, 9, -3));
    far.add(vec3(-20, -20, -6), vec3(20, -20, -6), vec3(0, 20, -6));
    far.facet_base = 7;
    const View view = near_view(32, 32);
    EXPECT_EQ(depth_of(view, {near, far}).at(16, 16).facet, 0u);
    EXPECT_TRUE(same(depth_of(view, {near, far}), depth_of(view, {far, near})));
}

TEST(Depth, EqualDepthGoesToTheLowerFacet) {
    TriangleSoup first;
    first.add(vec3(-9, -9, -3), vec3(9, -9, -3), vec3(0, 9, -3));
    TriangleSoup second = first;
    first.facet_base = 5;
    second.facet_base = 3;
    const View view = near_view(32, 32);
    EXPECT_EQ(depth_of(view, {first, second}).at(16, 16).facet, 3u);
    EXPECT_TRUE(same(depth_of(view, {first, second}), depth_of(view, {second, first})));
}

TEST(Depth, CutAtTheNearPlane) {
    // The floor y = -1 from far ahead to behind the eye: below the horizon it is seen from z = -near on.
    TriangleSoup floor;
    floor.add(vec3(-50, -1, 50), vec3(50, -1, 50), vec3(50, -1, -50), vec3(-50, -1, -50));
    const View view = near_view(40, 400);
    const DepthBuffer buffer = depth_of(view, {floor});
    for (int y = 0; y < view.height; ++y) {
        const double depth = plane_depth(view, dvec3(0, 1, 0), -1.0, dvec2(20.5, y + 0.5));
        const bool seen = depth <= 1.0 && depth > view.near_clip / 50.0;
        EXPECT_EQ(buffer.at(20, y).facet != none, seen) << y;
        if (seen) {
            EXPECT_NEAR(buffer.at(20, y).depth, depth, 1e-6);
        }
    }
    // A steep pane through the near plane: depth reaches, and never exceeds, 1.
    TriangleSoup pane;
    pane.add(vec3(-2, -1, 0.5f), vec3(2, -1, 0.5f), vec3(2, 1, -1.5f), vec3(-2, 1, -1.5f));
    float nearest = 0.0f;
    for (const auto& texel : depth_of(near_view(64, 64), {pane}).texels) nearest = std::max(nearest, texel.depth);
    EXPECT_LE(nearest, 1.0f);
    EXPECT_GT(nearest, 0.9f);
}

TEST(Depth, NothingIsTooFar) {
    TriangleSoup far;
    far.add(vec3(-1e5f, -1e5f, -1e4f), vec3(1e5f, -1e5f, -1e4f), vec3(0, 1e5f, -1e4f));
    EXPECT_NEAR(depth_of(near_view(8, 8), {far}).at(4, 4).depth, 0.5e-4, 1e-9);
    EXPECT_LT(depth_of(parallel_view(8, 8), {far}).at(4, 4).depth, 0.0f);
}

TEST(Depth, BrokenTrianglesLeaveNoTrace) {
    const float nan = std::numeric_limits<float>::quiet_NaN(), inf = std::numeric_limits<float>::infinity();
    TriangleSoup mesh;
    mesh.add(vec3(nan, 0, -3), vec3(1, 0, -3), vec3(0, 1, -3));
    mesh.add(vec3(inf, 0, -3), vec3(1, 0, -3), vec3(0, 1, -3));
    mesh.add(vec3(0, 0, -inf), vec3(1, 0, -3), vec3(0, 1, -3));
    mesh.add(vec3(0, 0, -3), vec3(0, 0, -3), vec3(0, 1, -3));
    mesh.add(vec3(-1, 0, -3), vec3(0, 0, -3), vec3(1, 0, -3));
    mesh.add(vec3(0, 0, 0), vec3(0, 0, 0), vec3(0, 0, 0));
    for (const auto& texel : depth_of(near_view(16, 16), {mesh}).texels) EXPECT_EQ(texel.facet, none);
}

TEST(Depth, BadInputIsRefused) {
    TriangleSoup mesh;
    mesh.add(vec3(0), vec3(1), vec3(2));
    EXPECT_THROW(depth_of(near_view(8, 8), {mesh}, 0), std::invalid_argument);
    EXPECT_THROW(depth_of(near_view(0, 8), {mesh}), std::invalid_argument);
    EXPECT_THROW(depth_layout(near_view(8, 8), {.margin = -1.0}), std::invalid_argument);
    mesh.triangles[0].y = 9;
    EXPECT_THROW(depth_of(near_view(8, 8), {mesh}), std::invalid_argument);
}

TEST(Depth, TheBorderShowsWhatLiesAroundTheFrame) {
    const TriangleSoup mesh = random_triangles(200, 7);
    const View view = near_view(60, 41);
    const DepthBuffer frame = depth_of(view, {mesh}, 2);
    const RasterMesh meshes[] = {mesh};
    const DepthBuffer wide = draw_depth(depth_layout(view, {.scale = 2, .margin = 0.3}), view, meshes);
    EXPECT_EQ(wide.border_x, 9);
    EXPECT_EQ(wide.border_y, 7);
    ASSERT_EQ(wide.width, frame.width + 4 * wide.border_x);
    ASSERT_EQ(wide.height, frame.height + 4 * wide.border_y);
    for (int y = 0; y < frame.height; ++y)
        for (int x = 0; x < frame.width; ++x) {
            const DepthTexel &a = frame.at(x, y), &b = wide.at(x + 2 * wide.border_x, y + 2 * wide.border_y);
            EXPECT_EQ(a.facet, b.facet);
            EXPECT_FLOAT_EQ(a.depth, b.depth);
            EXPECT_NEAR(a.ddx, b.ddx, 1e-6);
        }
}

TEST(Depth, SolidBodiesLookTheSameWithoutTheirFarSides) {
    const auto ball = meshes::sphere(16).surface(), box = meshes::box().surface(), sheet = meshes::grid(3).surface();
    const dmat4 far = glm::translate(dmat4(1.0), dvec3(0.4, 0.2, -6)), mirrored = glm::scale(far, dvec3(-1, 1.3, 1));
    const dmat4 near = glm::translate(dmat4(1.0), dvec3(-0.5, -0.3, -0.9));  // the near plane cuts it
    const Scene scene({{ball, far, 1},
                       {box, glm::rotate(mirrored, 0.5, dvec3(1, 1, 0)), 2},
                       {sheet, glm::rotate(far, 0.9, dvec3(1, 2, 0)), 3},
                       {ball, near, 4}});
    const View view = near_view(90, 70);
    std::vector<RasterMesh> meshes = depth_meshes(scene, view, 0.0);
    ASSERT_EQ(meshes.size(), 4u);
    const auto is_one_sided = [&](int mesh) { return meshes[mesh].one_sided_from == 0; };
    EXPECT_TRUE(is_one_sided(0) && is_one_sided(1) && !is_one_sided(2) && !is_one_sided(3));
    const DepthBuffer culled = depth_of(view, meshes, 2);
    for (RasterMesh& mesh : meshes) mesh.one_sided_from = none;
    EXPECT_TRUE(same(culled, depth_of(view, meshes, 2)));
}

TEST(Depth, SameWithOneAndManyThreads) {
    const TriangleSoup mesh = random_triangles(20000, 3);
    const View view = near_view(200, 150);
    const DepthBuffer many = depth_of(view, {mesh}, 2);
    tbb::global_control one(tbb::global_control::max_allowed_parallelism, 1);
    EXPECT_TRUE(same(many, depth_of(view, {mesh}, 2)));
}

TEST(Depth, TrianglesOfFewTexelsCoverWhatTheirRowsDo) {
    const View view = near_view(160, 120);
    std::mt19937 random(7);
    std::uniform_real_distribution<float> place(-4.0f, 4.0f), side(-0.12f, 0.12f);
    TriangleSoup mesh;
    for (int i = 0; i < 3000; ++i) {
        const vec3 at(place(random), place(random), place(random) - 6.0f);
        const auto corner = [&] { return at + vec3(side(random), side(random), side(random)); };
        const vec3 a = corner(), b = corner();
        mesh.add(a, b, corner());
    }
    const RasterTarget target = raster_target(view, depth_layout(view, {.scale = 1, .margin = 0.0}));
    const std::vector<RasterMesh> meshes{mesh};
    std::set<std::array<int, 3>> all, parts;  // triangle, row, texel
    std::mutex one_at_a_time;
    const auto rows_of = [&](std::set<std::array<int, 3>>& out) {
        return [&](const RasterTriangle& t, int y0, int y1) {
            const std::lock_guard lock(one_at_a_time);
            const TriangleRows rows(t);
            for (int y = y0; y < y1; ++y)
                for (auto [x, end] = rows.covered(y); x < end; ++x) out.insert({int(t.triangle), y, x});
        };
    };
    draw_triangles(target, meshes, nullptr, rows_of(all));
    std::size_t few = 0;
    draw_triangles(target, meshes, nullptr, rows_of(parts), [&](const RasterTriangle& t) {
        const std::lock_guard lock(one_at_a_time);
        ++few;
        const int across = t.x1 - t.x0;
        ASSERT_LE(across * (t.y1 - t.y0), RasterTriangle::most_of_few);
        for (int i = 0; i < RasterTriangle::most_of_few; ++i)
            if (t.few >> i & 1) parts.insert({int(t.triangle), t.y0 + i / across, t.x0 + i % across});
    });
    EXPECT_GT(few, 500u);
    EXPECT_GT(all.size(), 3 * few);
    EXPECT_EQ(all, parts);
}

TEST(Depth, AgreesWithRaysOnRandomTriangles) {
    const TriangleSoup mesh = random_triangles(60, 5);
    const View view = near_view(60, 50);
    const DepthBuffer buffer = depth_of(view, {mesh});
    for (int y = 0; y < view.height; ++y)
        for (int x = 0; x < view.width; ++x) {
            double nearest = 0.0;
            const dvec4 h = glm::inverse(view.view_to_clip) *
                            dvec4((x + 0.5) / view.width * 2 - 1, (y + 0.5) / view.height * 2 - 1, 1, 1);
            const dvec3 ray = dvec3(h) / h.w;
            for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
                const dvec3 a = mesh.positions[3 * i], b = mesh.positions[3 * i + 1], c = mesh.positions[3 * i + 2];
                const double ab = glm::dot(ray, glm::cross(a, b)), bc = glm::dot(ray, glm::cross(b, c)),
                             ca = glm::dot(ray, glm::cross(c, a));
                if (!((ab >= 0 && bc >= 0 && ca >= 0) || (ab <= 0 && bc <= 0 && ca <= 0))) continue;
                const dvec3 n = glm::cross(b - a, c - a);
                const double depth = screen_depth(view, ray.z * glm::dot(n, a) / glm::dot(n, ray));
                if (depth > 0.0 && depth <= 1.0) nearest = std::max(nearest, depth);
            }
            EXPECT_NEAR(buffer.at(x, y).depth, nearest, 1e-5) << x << " " << y;
        }
}
