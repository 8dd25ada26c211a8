// SPDX-License-Identifier: GPL-3.0-or-later
// A surface's BVH follows its vertices: rays say what they say of a surface that was made there.
#include <atomic>
#include <chrono>
#include <gtest/gtest.h>
#include <random>
#include <tbb/global_control.h>
#include <tbb/task_arena.h>
#include <thread>

#include <fovea/base/parallel.h>
#include <fovea/scene/bvh.h>

#include "drawing.h"

using namespace fovea;
using namespace fovea::draw;
using namespace fovea::meshes;
using namespace fovea::drawing;

namespace {

const View level_view = perspective({0, -6, 1}, {0, 0, 0}, 36);

/// A sphere of quads, bent and pulled by step k.
Mesh bent(int k) {
    Mesh mesh = sphere(40);
    for (vec3& p : mesh.positions) {
        const float angle = 0.3f * k * p.z;
        p = vec3(std::cos(angle) * p.x - std::sin(angle) * p.y, std::sin(angle) * p.x + std::cos(angle) * p.y, p.z);
        p.x *= 1.0f + 0.2f * k * p.z * p.z;
    }
    return mesh;
}

/// The moved surface and a new one at the same place hide the same of each other's scene.
void expect_same(const std::shared_ptr<Surface>& moved_surface, const Mesh& now, const char* what) {
    const Placement behind = place(grid(12), moved({0, 2, 0}) * dmat4(glm::rotate(dmat4(1.0), 1.5, dvec3(1, 0, 0))), 2);
    const LineSet all = line_set_with("crease", {0, 1});
    const Drawing old({{moved_surface, dmat4(1.0), 1}, behind}, level_view, {all});
    const Drawing fresh({place(now), behind}, level_view, {all});
    ASSERT_EQ(old.clipped.samples, fresh.clipped.samples) << what;
    ASSERT_EQ(old.runs.size(), fresh.runs.size()) << what;
    ASSERT_GT(old.runs.size(), 50u) << what;
    EXPECT_EQ(old.runs.piece, fresh.runs.piece) << what;
    for (std::size_t r = 0; r < old.runs.size(); ++r) {
        EXPECT_NEAR(old.runs.start_px[r], fresh.runs.start_px[r], 1e-6) << what;
        EXPECT_NEAR(old.runs.end_px[r], fresh.runs.end_px[r], 1e-6) << what;
    }
}

constexpr auto all_of_it = [](const Hit& hit) { return std::tuple(hit.triangle, hit.t, hit.u, hit.v); };

/// Number of rays that hit; what told(hit) tells must be the same of both scenes, to the last bit.
template <typename Told = decltype(all_of_it)>
int same_hits(const Scene& one, const Scene& other, const View& seen, const Told& told = all_of_it) {
    const Tracer first(one, seen), second(other, seen);
    int hits = 0;
    for (int y = 0; y < 480; y += 2)
        for (int x = 0; x < 640; x += 2) {
            const auto a = first.seen({x + 0.37, y + 0.41}), b = second.seen({x + 0.37, y + 0.41});
            EXPECT_EQ(a.has_value(), b.has_value());
            if (!a || !b) continue;
            EXPECT_EQ(told(*a), told(*b));
            ++hits;
        }
    return hits;
}

}  // namespace

TEST(Bvh, FollowsASurfaceThatMoves) {
    const auto surface = bent(0).surface();
    expect_same(surface, bent(0), "at rest");
    for (int k = 1; k <= 6; ++k) {
        surface->set_positions(bent(k).positions, true);
        expect_same(surface, bent(k), "bent");
    }
    surface->set_positions(bent(0).positions, true);
    expect_same(surface, bent(0), "back again");
}

TEST(Bvh, FollowsVerticesThatAreThrownAbout) {
    const auto surface = bent(0).surface();
    std::mt19937 random(5);
    for (int k = 0; k < 3; ++k) {
        // Vertices change places: what lay side by side no longer does.
        Mesh mesh = bent(1);
        std::shuffle(mesh.positions.begin(), mesh.positions.end(), random);
        surface->set_positions(mesh.positions, true);
        const auto fresh = mesh.surface();
        const Scene old_scene({{surface, dmat4(1.0), 1}}), new_scene({{fresh, dmat4(1.0), 1}});
        const Tracer old_tracer(old_scene, level_view), new_tracer(new_scene, level_view);
        int hits = 0;
        for (int y = 3; y < 480; y += 7)
            for (int x = 3; x < 640; x += 7) {
                const auto a = old_tracer.seen({x + 0.37, y + 0.41}), b = new_tracer.seen({x + 0.37, y + 0.41});
                ASSERT_EQ(a.has_value(), b.has_value());
                if (!a || !b) continue;
                EXPECT_NEAR(a->t, b->t, 1e-5);
                ++hits;
            }
        EXPECT_GT(hits, 300);
    }
}

TEST(Bvh, FollowsAQuadThatBendsAndLosesATriangle) {
    // Bent the other way, and flat to nothing: other triangles, and fewer.
    Mesh mesh = bent_quad(0.5f);
    const auto surface = mesh.surface();
    const auto hit_at = [&](const Mesh& now) {
        const Placement placed{surface, moved({-0.5, 0, -0.5}) * glm::rotate(dmat4(1.0), 1.57, dvec3(1, 0, 0)), 1};
        const Scene old_scene({placed}), new_scene({{now.surface(), placed.object_to_world, 1}});
        const Tracer old_tracer(old_scene, level_view), new_tracer(new_scene, level_view);
        int differ = 0, hits = 0;
        for (int y = 0; y < 480; y += 3)
            for (int x = 0; x < 640; x += 3) {
                const auto a = old_tracer.seen({x + 0.3, y + 0.4}), b = new_tracer.seen({x + 0.3, y + 0.4});
                differ += a.has_value() != b.has_value() || (a && std::abs(a->t - b->t) > 1e-5);
                hits += a.has_value();
            }
        EXPECT_EQ(differ, 0);
        return hits;
    };
    const int at_first = hit_at(mesh);
    EXPECT_GT(at_first, 300);
    mesh.positions[2] = vec3(0.2f, 0.2f, 0.4f);  // an arrow head
    surface->set_positions(mesh.positions, true);
    EXPECT_LT(hit_at(mesh), at_first);
    for (vec3& p : mesh.positions) p.y = 0.0f;  // no area
    mesh.positions[2].z = 0.0f;
    surface->set_positions(mesh.positions, true);
    EXPECT_EQ(hit_at(mesh), 0);
    mesh.positions = bent_quad(0.5f).positions;
    surface->set_positions(mesh.positions, true);
    EXPECT_EQ(hit_at(mesh), at_first);
}

TEST(Bvh, OfASurfaceMovedWithoutRefitTellsWhatThatOfANewOneDoesToTheLastBit) {
    const auto surface = bent(0).surface();
    for (int k = 1; k <= 4; ++k) {
        surface->set_positions(bent(k).positions);
        const Scene old_scene({{surface, dmat4(1.0), 1}}), new_scene({{bent(k).surface(), dmat4(1.0), 1}});
        EXPECT_GT(same_hits(old_scene, new_scene, level_view), 3000) << k;
    }
}

TEST(Bvh, RaysTellTheSameOfASurfaceWithAVertexThatWasFlungAway) {
    const Mesh whole = sphere(40);
    const auto with_vertex_at = [&](float far) {
        Mesh mesh = whole;
        mesh.positions.push_back({0.0f, far, -far / 6.0f});  // behind the sphere, as the eye sees it
        const int last = static_cast<int>(mesh.positions.size()) - 1;
        mesh.add_polygon({0, 1, last});
        return mesh;
    };
    const Scene alone({{whole.surface(), dmat4(1.0), 1}});
    const auto told = [](const Hit& hit) { return std::tuple(hit.t, hit.u, hit.v); };
    const auto moves = with_vertex_at(4.0f).surface();
    for (const float far : {1e2f, 1e5f, 1e10f, 1e18f, 4.0f}) {
        const auto surface = with_vertex_at(far).surface();
        EXPECT_GT(same_hits(alone, Scene({{surface, dmat4(1.0), 1}}), level_view, told), 3000) << far;
        moves->set_positions(with_vertex_at(far).positions, true);
        EXPECT_GT(same_hits(alone, Scene({{moves, dmat4(1.0), 1}}), level_view, told), 3000) << far << ", moved";
    }
}

TEST(Bvh, OfASurfaceMovedWithRefitDoesSo) {
    const auto surface = bent(0).surface();
    for (int k = 1; k <= 4; ++k) {
        surface->set_positions(bent(k).positions, true);
        const dmat4 turned = glm::rotate(dmat4(1.0), 0.3, dvec3(1, 2, 3));
        const Scene old_scene({{surface, turned, 1}}), new_scene({{bent(k).surface(), turned, 1}});
        EXPECT_GT(same_hits(old_scene, new_scene, level_view), 3000) << k;
    }
}

TEST(Bvh, WhoFollowsASurfaceThatMovedTakesNoOtherWorkMeanwhile) {
    // Work for the same surface would wait for that which it interrupts. Helpers in its loops are slow here.
    static thread_local int following = 0;
    struct Slow : Cancel {
        bool asked() const override {
            if (following == 0) std::this_thread::sleep_for(std::chrono::milliseconds(2));
            return false;
        }
    } const slow;
    const tbb::global_control threads(tbb::global_control::max_allowed_parallelism, 8);
    tbb::task_arena arena(8);
    Mesh mesh = sphere(80);
    std::vector<std::shared_ptr<Surface>> surfaces;
    for (int i = 0; i < 48; ++i) surfaces.push_back(mesh.surface());
    std::atomic<int> deepest = 0;
    for (int k = 0; k < 5; ++k) {
        for (vec3& p : mesh.positions) p *= 1.01f;
        for (const auto& surface : surfaces) surface->set_positions(mesh.positions, true);
        arena.execute([&] {
            parallel_for(surfaces.size(), 1, [&](std::size_t i) {
                const Cancelling scope(&slow);
                ++following;
                if (following > deepest) deepest = following;
                bvh_of(*surfaces[i]);
                --following;
            });
        });
    }
    EXPECT_EQ(deepest, 1);
}

TEST(Bvh, OfASurfaceOfManyTrianglesTellsWhatThoseOfItsPartsDo) {
    constexpr int side = 370, parts = 4;  // 273800 triangles, more than have BVHs of the best quality
    Mesh whole = grid(side);
    for (vec3& p : whole.positions) p.z = 0.2f * std::sin(9.0f * p.x) * std::cos(7.0f * p.y);
    std::vector<Placement> apart;
    for (int part = 0; part < parts; ++part) {
        Polygons polygons;
        for (int f = part; f < side * side; f += parts)  // neighbors are of different parts
            polygons.emplace_back(whole.corner_verts.begin() + 4 * f, whole.corner_verts.begin() + 4 * (f + 1));
        apart.push_back({of_polygons("part", whole.positions, polygons).surface(), dmat4(1.0), Index(part + 1)});
    }
    const View above = perspective({0.3, -2.5, 1.5}, {0, 0, 0}, 40);
    const Scene one({{whole.surface(), dmat4(1.0), 1}}), many(apart);
    EXPECT_GT(same_hits(one, many, above, [](const Hit& hit) { return hit.t; }), 10000);
}

TEST(Bvh, RefittedHitsTheSameAlongRaysThroughVerticesAndSides) {
    // Looked at from straight above, 20 pixels to a square.
    const View above = orthographic({0, 0, 5}, {0, 0, 0}, 3.2);
    const auto surface = grid(10).surface();
    for (const float height : {0.5f, 0.25f, 1.0f}) {
        Mesh mesh = grid(10);
        for (vec3& p : mesh.positions) p.z = height * p.x * p.x;
        surface->set_positions(mesh.positions, true);
        const Scene old_scene({{surface, dmat4(1.0), 1}}), new_scene({{mesh.surface(), dmat4(1.0), 1}});
        const Tracer old_tracer(old_scene, above), new_tracer(new_scene, above);
        int hits = 0;
        for (int y = 0; y < 480; y += 4)
            for (int x = 0; x < 640; x += 4) {
                const auto a = old_tracer.seen({x, y}), b = new_tracer.seen({x, y});
                ASSERT_EQ(a.has_value(), b.has_value()) << x << " " << y;
                if (!a) continue;
                EXPECT_EQ(std::tuple(a->triangle, a->t), std::tuple(b->triangle, b->t)) << x << " " << y;
                ++hits;
            }
        EXPECT_GT(hits, 3000);
    }
}
