// Intersections of surfaces whose curves are known.
#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <cstring>
#include <glm/gtc/quaternion.hpp>
#include <limits>
#include <random>

#include "drawing.h"

using namespace fovea;
using namespace fovea::meshes;
using namespace fovea::drawing;

namespace {

const View somewhere = perspective({9, -12, 7}, {0, 0, 0}, 30);

/// What the paths of a scene are, in the world.
struct Found {
    Index count = 0, closed = 0, points = 0;
    double length = 0.0;
    std::vector<double> lengths;   // per path, ascending
    std::vector<dvec3> at;

    explicit Found(std::vector<Placement> placements, const Values& values = {1, 1}) {
        const Drawing drawing(std::move(placements), somewhere, {line_set_with("intersection", values)});
        const Paths& paths = drawing.paths;
        count = paths.count();
        for (Index p = 0; p < count; ++p) {
            const dmat4& to_world = drawing.scene.placements[paths.placement[p]].object_to_world;
            double length_of_path = 0.0;
            for (Index i = paths.rows.begin(p); i < paths.rows.end(p); ++i) {
                at.push_back(dvec3(to_world * dvec4(dvec3(paths.points_obj[i]), 1.0)));
                if (i > paths.rows.begin(p)) length_of_path += glm::distance(at.back(), at[at.size() - 2]);
            }
            closed += paths.closed[p];
            lengths.push_back(length_of_path);
            length += length_of_path;
        }
        points = static_cast<Index>(at.size());
        std::sort(lengths.begin(), lengths.end());
    }
};

Placement put(const Mesh& mesh, dmat4 at, std::uint64_t id) { return place(mesh, at, id); }

dmat4 turned(double angle, dvec3 axis) { return glm::mat4_cast(glm::angleAxis(angle, glm::normalize(axis))); }

Mesh torus(double big, double small, int around, int across) {
    Mesh mesh("torus", {});
    for (int i = 0; i < around; ++i)
        for (int j = 0; j < across; ++j) {
            const double a = 2 * std::numbers::pi * i / around, b = 2 * std::numbers::pi * j / across;
            const double r = big + small * std::cos(b);
            mesh.positions.push_back(vec3(dvec3(r * std::cos(a), r * std::sin(a), small * std::sin(b))));
        }
    const auto at = [&](int i, int j) { return (i % around) * across + j % across; };
    for (int i = 0; i < around; ++i)
        for (int j = 0; j < across; ++j) mesh.add_polygon({at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)});
    return mesh;
}

/// Meshes as one object.
Mesh joined(const std::vector<std::pair<Mesh, dmat4>>& parts) {
    Mesh mesh("joined", {});
    for (const auto& [part, at] : parts) {
        const int base = static_cast<int>(mesh.positions.size());
        for (const vec3& p : part.positions) mesh.positions.push_back(vec3(at * dvec4(dvec3(p), 1.0)));
        for (std::size_t f = 0; f + 1 < part.polygon_offsets.size(); ++f) {
            std::vector<int> verts;
            for (int c = part.polygon_offsets[f]; c < part.polygon_offsets[f + 1]; ++c)
                verts.push_back(base + part.corner_verts[c]);
            mesh.add_polygon(verts);
        }
    }
    return mesh;
}

/// A wall whose plan is a figure of eight: it crosses itself along the z axis.
Mesh eight(int n) {
    Mesh mesh("eight", {});
    for (int i = 0; i < n; ++i) {
        const double t = 2 * std::numbers::pi * (i + 0.5) / n;
        for (const float z : {-1.0f, 1.0f}) mesh.positions.push_back({float(std::sin(2 * t)), float(2 * std::sin(t)), z});
    }
    for (int i = 0; i < n; ++i) {
        const int j = (i + 1) % n;
        mesh.add_polygon({2 * i, 2 * j, 2 * j + 1, 2 * i + 1});
    }
    return mesh;
}

/// Every triangle with corners of its own.
Mesh split(const Mesh& mesh) {
    Mesh result(mesh.name, {});
    for (std::size_t f = 0; f + 1 < mesh.polygon_offsets.size(); ++f) {
        std::vector<int> verts;
        for (int c = mesh.polygon_offsets[f]; c < mesh.polygon_offsets[f + 1]; ++c) {
            verts.push_back(static_cast<int>(result.positions.size()));
            result.positions.push_back(mesh.positions[mesh.corner_verts[c]]);
        }
        result.add_polygon(verts);
    }
    return result;
}

}  // namespace

TEST(Intersection, OfTwoSpheresIsACircle) {
    const int n = 48;
    const Found found({put(sphere(n), moved({-0.5, 0, 0}), 1),
                       put(sphere(n), moved({0.5, 0, 0}) * turned(0.7, {1, 2, 3}), 2)});
    ASSERT_EQ(found.count, 1u);
    EXPECT_EQ(found.closed, 1u);
    const double radius = std::sqrt(0.75), facet = 1.0 - std::cos(std::numbers::pi / n);
    EXPECT_NEAR(found.length, 2 * std::numbers::pi * radius, 0.01);
    for (const dvec3& p : found.at) {
        EXPECT_NEAR(p.x, 0.0, 2 * facet);
        EXPECT_NEAR(std::hypot(p.y, p.z), radius, 3 * facet);
    }
}

TEST(Intersection, OfABoxThroughAPlaneIsARectangle) {
    const Found found({put(grid(7, 3), moved({0, 0, 0.25}), 1), put(box(), dmat4(1.0), 2)});
    ASSERT_EQ(found.count, 1u);
    EXPECT_EQ(found.closed, 1u);
    EXPECT_NEAR(found.length, 8.0, 1e-6);
    for (const dvec3& p : found.at) {
        EXPECT_NEAR(p.z, 0.25, 1e-6);
        EXPECT_NEAR(std::max(std::abs(p.x), std::abs(p.y)), 1.0, 1e-6);
    }
}

TEST(Intersection, OfATorusAndAPlaneIsTwoCircles) {
    const Mesh ring = torus(2, 0.5, 64, 32);
    const double chord = 64 * 2 * std::sin(std::numbers::pi / 64), around = 32 * 2 * std::sin(std::numbers::pi / 32);
    // Through all vertices of both equators, which lie in the plane exactly; and across.
    const Found flat({put(ring, dmat4(1.0), 1), put(grid(1, 4), dmat4(1.0), 2)});
    ASSERT_EQ(flat.lengths.size(), 2u);
    EXPECT_EQ(flat.closed, 2u);
    EXPECT_NEAR(flat.lengths[0], 1.5 * chord, 1e-4);
    EXPECT_NEAR(flat.lengths[1], 2.5 * chord, 1e-4);
    const Found upright({put(ring, dmat4(1.0), 1), put(grid(1, 4), turned(std::numbers::pi / 2, {1, 0, 0}), 2)});
    ASSERT_EQ(upright.lengths.size(), 2u);
    EXPECT_EQ(upright.closed, 2u);
    for (const double length : upright.lengths) EXPECT_NEAR(length, 0.5 * around, 1e-4);
}

TEST(Intersection, WithinAnObjectIsWhereItsPartsCross) {
    const dmat4 other = moved({0.7, 0.6, 0.5}) * turned(0.4, {3, 1, 2});
    const Found apart({put(box(), dmat4(1.0), 1), put(box(), other, 2)});
    const Found together({put(joined({{box(), dmat4(1.0)}, {box(), other}}), dmat4(1.0), 1)});
    ASSERT_EQ(apart.count, 1u);
    EXPECT_EQ(apart.closed, 1u);
    EXPECT_EQ(together.count, 1u);
    EXPECT_EQ(together.closed, 1u);
    EXPECT_NEAR(together.length, apart.length, 1e-5);
    EXPECT_EQ(Found({put(joined({{box(), dmat4(1.0)}, {box(), other}}), dmat4(1.0), 1)}, {1, 0}).count, 0u);
    EXPECT_EQ(Found({put(box(), dmat4(1.0), 1), put(box(), other, 2)}, {0, 1}).count, 0u);
}

TEST(Intersection, OfASurfaceThatCrossesItself) {
    const Found found({put(eight(40), dmat4(1.0), 1)});
    ASSERT_EQ(found.count, 1u);
    EXPECT_EQ(found.closed, 0u) << "it ends at the borders";
    EXPECT_NEAR(found.length, 2.0, 1e-5);
    for (const dvec3& p : found.at) EXPECT_NEAR(std::hypot(p.x, p.y), 0.0, 1e-6);
    // Through a vertex of both parts at once: two cones tip to tip in a mesh, one through the other.
    const Mesh cross = of_polygons("cross", {{0, 0, 0}, {1, -1, 0}, {1, 1, 0}, {0.5, 0, -1}, {0.5, 0, 1}},
                                   {{0, 1, 2}, {0, 3, 4}});
    const Found at_vertex({put(cross, dmat4(1.0), 1)});
    ASSERT_EQ(at_vertex.count, 1u);
    EXPECT_NEAR(at_vertex.length, 0.5, 1e-6);
}

TEST(Intersection, NeighboursDoNotIntersect) {
    for (const Mesh& mesh : {box(), sphere(24), two_boxes_at_an_edge(), moebius(24), grid(8), tetrahedron(), bent_quad(),
                             l_shape(), torus(2, 0.5, 24, 12), cylinder(12)}) {
        EXPECT_EQ(Found({put(mesh, turned(0.3, {1, 2, 3}), 1)}).count, 0u) << mesh.name;
        EXPECT_EQ(Found({put(split(mesh), dmat4(1.0), 1)}).count, 0u) << mesh.name << ", split";
    }
}

TEST(Intersection, SurfacesThatTouchHaveNone) {
    const Mesh floor = grid(3, 4);
    const dmat4 on_floor = moved({0.3, 0.1, 1});
    const dmat4 motions[] = {dmat4(1.0), moved({5, 3, 1}) * turned(1.1, {1, 2, 3}), turned(2.2, {-3, 1, 1}) * scaled(dvec3(3))};
    for (const dmat4& motion : motions) {
        EXPECT_EQ(Found({put(floor, motion, 1), put(box(), motion * on_floor, 2)}).count, 0u) << "a box on a floor";
        EXPECT_EQ(Found({put(floor, motion, 2), put(box(), motion * on_floor, 1)}).count, 0u);
        EXPECT_EQ(Found({put(joined({{floor, dmat4(1.0)}, {box(), on_floor}}), motion, 1)}).count, 0u) << "in one object";
        EXPECT_EQ(Found({put(box(), motion, 1), put(box(), motion * moved({2, 0.5, 0.5}), 2)}).count, 0u) << "side by side";
        EXPECT_EQ(Found({put(box(), motion, 1), put(box(), motion, 2)}).count, 0u) << "in the same place";
        EXPECT_EQ(Found({put(floor, motion, 1), put(tetrahedron(), motion * moved({0, 0, 1}), 2)}).count, 0u) << "on an edge";
    }
    for (const double depth : {1e-7, -1e-7})
        EXPECT_EQ(Found({put(floor, dmat4(1.0), 1), put(box(), moved({0.3, 0.1, 1 - depth}), 2)}).count, 0u);
    const Found sunk({put(floor, dmat4(1.0), 1), put(box(), moved({0.3, 0.1, 0.999}), 2)});
    EXPECT_EQ(sunk.count, 1u);
    EXPECT_EQ(sunk.closed, 1u);
}

TEST(Intersection, OfFlushBoxesIsWhereTheyCross) {
    // Tops and bottoms lie in the same planes; two sides of the second cross a face of the first.
    const Found found({put(box(), dmat4(1.0), 1), put(box(), moved({1, 0.1, 0}) * scaled({1, 0.5, 1}), 2)});
    ASSERT_EQ(found.count, 2u);
    EXPECT_EQ(found.closed, 0u);
    for (const double length : found.lengths) EXPECT_NEAR(length, 2.0, 1e-5);
    for (const dvec3& p : found.at) {
        EXPECT_NEAR(p.x, 1.0, 1e-6);
        EXPECT_NEAR(std::abs(p.y - 0.1), 0.5, 1e-6);
    }
}

TEST(Intersection, BrokenAndThinTrianglesLeaveNoGaps) {
    // A sphere split into slivers: every quad has a vertex next to the middle of a side, or on it exactly.
    for (const float off : {0.0f, 1e-7f, 1e-4f}) {
        Mesh mesh("slivers", {{0, 0, 1.2f}, {0, 0, -1.2f}});
        const int n = 12;
        for (int i = 0; i < n; ++i) {
            const double a = 2 * std::numbers::pi * i / n;
            mesh.positions.push_back(vec3(dvec3(std::cos(a), std::sin(a), 0)));
        }
        for (int i = 0; i < n; ++i) {
            const int a = 2 + i, b = 2 + (i + 1) % n, m = static_cast<int>(mesh.positions.size());
            mesh.positions.push_back(0.5f * (mesh.positions[a] + mesh.positions[0]) + vec3(0, 0, off));
            mesh.add_polygon({a, b, m});
            mesh.add_polygon({m, b, 0});
            mesh.add_polygon({a, m, 0});  // a sliver
            mesh.add_polygon({b, a, 1});
        }
        const Found found({put(mesh, dmat4(1.0), 1), put(grid(5, 3), turned(0.2, {1, 2, 0}) * moved({0, 0, 0.3}), 2)});
        EXPECT_GE(found.count, 1u) << off;
        EXPECT_GE(found.length, 4.0) << off;
        if (off > 0.0f) {
            EXPECT_EQ(found.count, 1u) << off;
            EXPECT_EQ(found.closed, 1u) << off;
        }
    }
    Mesh broken = sphere(16);
    const Found whole({put(broken, dmat4(1.0), 1), put(grid(1, 3), moved({0, 0, 0.1}), 2)});
    broken.positions[20] = vec3(std::numeric_limits<float>::quiet_NaN());
    broken.positions[60] = vec3(std::numeric_limits<float>::infinity());
    const Found rest({put(broken, dmat4(1.0), 1), put(grid(1, 3), moved({0, 0, 0.1}), 2)});
    EXPECT_EQ(whole.closed, 1u);
    EXPECT_GT(rest.length, 0.7 * whole.length);
    EXPECT_LE(rest.length, whole.length);
    for (const dvec3& p : rest.at) EXPECT_NEAR(p.z, 0.1, 1e-6);
}

TEST(Intersection, IsClosedWhereSurfacesAre) {
    std::mt19937 random(5);
    std::uniform_real_distribution<double> unit(-1, 1);
    const auto any = [&] { return dvec3(unit(random), unit(random), unit(random)); };
    const Mesh shapes[] = {box(), sphere(9), tetrahedron(), torus(1, 0.4, 16, 8)};
    std::vector<Placement> placements;
    for (std::uint64_t i = 0; i < 60; ++i) {
        const dmat4 turn = turned(3.0 * unit(random), any() + dvec3(1e-3));
        placements.push_back(put(shapes[i % 4], moved(1.5 * any()) * turn * scaled(0.4 + 0.3 * any()), i));
    }
    const Found found(placements);
    EXPECT_GT(found.count, 100u);
    EXPECT_EQ(found.closed, found.count);
}

TEST(Intersection, IsClosedWhereVerticesLieInEachOthersFaces) {
    // Equators, poles and meridians lie in the faces of boxes, and edges cross in one point.
    std::vector<Placement> placements;
    std::uint64_t id = 0;
    for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j) {
            placements.push_back(put(sphere(8), moved({2.0 * i, 2.0 * j, 0}), ++id));
            placements.push_back(put(box(), moved({2.0 * i + 1, 2.0 * j, 0}) * scaled(dvec3(0.5)), ++id));
        }
    placements.push_back(put(grid(6, 6), dmat4(1.0), ++id));
    const Found found(placements, {1, 0});
    EXPECT_GT(found.count, 15u);
    EXPECT_EQ(found.closed, found.count);
}

TEST(Intersection, DoesNotDependOnMotionOrOrder) {
    const Mesh ball = sphere(20), brick = box();
    const dmat4 in_ball = moved({0.6, 0.5, 0.3}) * turned(0.5, {1, 1, 0});
    const Found found({put(ball, dmat4(1.0), 1), put(brick, in_ball, 2)});
    EXPECT_EQ(found.closed, 1u);
    for (const dmat4& motion : {moved({3, -2, 1}) * turned(1.3, {1, 2, 3}), scaled(dvec3(2)), scaled({-1, 1, 1})}) {
        const Found again({put(ball, motion, 1), put(brick, motion * in_ball, 2)});
        EXPECT_EQ(again.closed, found.count);
        EXPECT_EQ(again.points, found.points);
        EXPECT_NEAR(again.length, found.length * std::abs(motion[0][0] == 2.0 ? 2.0 : 1.0), 1e-4);
    }
    const auto sorted = [](Found f) {
        std::sort(f.at.begin(), f.at.end(), [](const dvec3& a, const dvec3& b) {
            return a.x != b.x ? a.x < b.x : a.y != b.y ? a.y < b.y : a.z < b.z;
        });
        f.at.erase(std::unique(f.at.begin(), f.at.end(), [](const dvec3& a, const dvec3& b) { return glm::distance(a, b) < 1e-9; }), f.at.end());
        return f.at;
    };
    // Faces in another order and turned around.
    Mesh shuffled(ball.name, ball.positions);
    for (std::size_t f = ball.polygon_offsets.size() - 1; f-- > 0;) {
        std::vector<int> verts(ball.corner_verts.begin() + ball.polygon_offsets[f],
                               ball.corner_verts.begin() + ball.polygon_offsets[f + 1]);
        if (f % 3 == 0 && verts.size() == 3) std::reverse(verts.begin(), verts.end());
        shuffled.add_polygon(verts);
    }
    const auto before = sorted(found), after = sorted(Found({put(shuffled, dmat4(1.0), 1), put(brick, in_ball, 2)}));
    ASSERT_EQ(before.size(), after.size());
    for (std::size_t i = 0; i < before.size(); ++i) EXPECT_NEAR(glm::distance(before[i], after[i]), 0.0, 1e-6);
}

TEST(Intersection, IsTheSameWithOneThreadAndMany) {
    const auto run = [&](std::size_t threads) {
        const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
        std::vector<Placement> placements;
        for (std::uint64_t i = 0; i < 12; ++i)
            placements.push_back(put(i % 2 ? sphere(60) : torus(1, 0.4, 50, 30), moved({0.3 * double(i % 4), 0.4 * double(i / 4), 0.1}), i));
        Drawing drawing(placements, somewhere, {line_set({"intersection"})});
        return std::move(drawing.paths);
    };
    const Paths one = run(1);
    ASSERT_GT(one.count(), 20u);
    for (const std::size_t threads : {2u, 8u}) {
        const Paths many = run(threads);
        ASSERT_EQ(one.points_obj.size(), many.points_obj.size());
        EXPECT_EQ(std::memcmp(one.points_obj.data(), many.points_obj.data(), one.points_obj.size() * sizeof(vec3)), 0);
        EXPECT_EQ(one.id, many.id);
        EXPECT_EQ(one.other_facet, many.other_facet);
    }
    EXPECT_EQ(std::set<std::uint64_t>(one.id.begin(), one.id.end()).size(), one.count()) << "no two ids are the same";
}

TEST(Intersection, IsFoundOnceForAllViewsAndForWhatMovesTogether) {
    const LineDefinition& definition = *line_definitions()[definition_index("intersection")];
    const auto ball = sphere(20).surface(), brick = box().surface();
    const auto find = [&](dmat4 first, dmat4 second) {
        const Scene scene({{ball, first, 1}, {brick, second, 2}});
        const std::vector<Index> drawn = {0, 1};
        const auto found = definition.find_in_scene(scene, drawn, {1, 0}, Cancel());
        return found.size() == 1 ? found[0].curves : nullptr;
    };
    const dmat4 motion = moved({3, -2, 1}) * turned(1.3, {1, 2, 3}), apart = moved({0.5, 0.5, 0.5});
    const auto once = find(dmat4(1.0), apart);
    ASSERT_NE(once, nullptr);
    EXPECT_FALSE(once->pieces.empty());
    EXPECT_EQ(find(dmat4(1.0), apart), once);
    EXPECT_EQ(find(motion, motion * apart), once);
    EXPECT_NE(find(dmat4(1.0), moved({0.5, 0.5, 0.6})), once);
    std::vector<vec3> positions(brick->positions.begin(), brick->positions.end() - 1);
    for (vec3& p : positions) p *= 1.5f;
    brick->set_positions(positions);
    const auto grown = find(dmat4(1.0), apart);
    EXPECT_NE(grown, once);
    EXPECT_NE(grown->pieces.size(), once->pieces.size());
}

TEST(Intersection, FlattenedAndHiddenObjectsDoNoHarm) {
    const Found flat({put(box(), scaled({2, 2, 0}), 1), put(box(), turned(0.5, {1, 0, 0}), 2)});
    EXPECT_GT(flat.length, 4.0) << "a box flattened to a sheet through a box";
    EXPECT_EQ(Found({put(box(), scaled({1, 1, 0}), 1), put(box(), scaled({1, 0, 1}), 2)}).count, 0u);
    EXPECT_EQ(Found({put(box(), scaled(dvec3(1e30)), 1), put(box(), dmat4(1.0), 2)}).count, 0u);
    EXPECT_EQ(Found({place(box(), dmat4(1.0), 1, usage_occlude), put(box(), moved(dvec3(0.5)), 2)}).count, 0u);
    EXPECT_EQ(Found({put(Mesh("empty", {}), dmat4(1.0), 1), put(box(), dmat4(1.0), 2)}).count, 0u);
}
