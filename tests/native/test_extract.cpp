// SPDX-License-Identifier: GPL-3.0-or-later
// Paths of a scene: line sets, ids, what is left out.
#include <cstring>
#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include "drawing.h"

using namespace fovea;
using namespace fovea::draw;
using namespace fovea::meshes;
using namespace fovea::drawing;

namespace {

Paths extract(const Scene& scene, const View& view, const std::vector<LineSet>& sets) {
    const Tracer tracer(scene, view);
    return extract_paths(scene, view, sets, tracer, Cancel());
}

/// Ids of paths by their lowest edge.
std::map<Index, std::uint64_t> ids(const Paths& paths) {
    std::map<Index, std::uint64_t> result;
    for (Index p = 0; p < paths.count(); ++p)
        result[*std::min_element(paths.place.begin() + paths.rows.begin(p), paths.place.begin() + paths.rows.end(p))] =
            paths.id[p];
    return result;
}

template <typename T>
void expect_same_bits(const Array<T>& a, const Array<T>& b) {
    ASSERT_EQ(a.size(), b.size());
    EXPECT_EQ(std::memcmp(a.data(), b.data(), a.size() * sizeof(T)), 0);
}

}  // namespace

TEST(Extract, IdsOfStaticLinesStayWhenTheCameraMoves) {
    const auto surface = box().surface();
    const Scene scene({{surface, dmat4(1.0), 77}});
    const LineSet creases = line_set({"crease"});
    const auto first = ids(extract(scene, corner_view, {creases}));
    ASSERT_EQ(first.size(), 12u);
    for (const dvec3 eye : {dvec3(-4, 2, 3), dvec3(0.5, 6, -4), dvec3(4, -5, 3)})
        EXPECT_EQ(ids(extract(scene, perspective(eye, {0, 0, 0}), {creases})), first);
    EXPECT_EQ(ids(extract(Scene({place(box(), dmat4(1.0), 77)}), corner_view, {creases})), first) << "a new surface";
    const auto other = ids(extract(Scene({{surface, dmat4(1.0), 78}}), corner_view, {creases}));
    for (const auto& [edge, id] : first) EXPECT_NE(other.at(edge), id) << "another object";
}

TEST(Extract, TheFirstLineSetThatFindsAnEdgeHasIt) {
    const Scene scene({place(box())});
    const auto labels = [&](const std::vector<LineSet>& sets) {
        const Paths paths = extract(scene, corner_view, sets);
        std::map<int, int> edges;
        for (Index p = 0; p < paths.count(); ++p) edges[paths.line_set[p]] += paths.rows.size(p) - 1;
        return edges;
    };
    const LineSet contours = line_set({"contour"}), creases = line_set({"crease"});
    EXPECT_EQ(labels({contours, creases}), (std::map<int, int>{{0, 6}, {1, 6}}));
    EXPECT_EQ(labels({creases, contours}), (std::map<int, int>{{0, 12}}));
    EXPECT_EQ(labels({contours}), (std::map<int, int>{{0, 6}}));
    EXPECT_TRUE(labels({}).empty());
    EXPECT_TRUE(labels({LineSet{}}).empty()) << "a line set without kinds";
}

TEST(Extract, ALineSetMayBeForSomePlacementsAlone) {
    const auto surface = box().surface();
    const Scene scene({{surface, moved({-1.5, 0, 0}), 1}, {surface, moved({1.5, 0, 0}), 2}});
    const auto edges = [&](const std::vector<LineSet>& sets) {
        const Paths paths = extract(scene, corner_view, sets);
        std::map<std::pair<int, int>, int> found;  // (placement, line set): edges
        for (Index p = 0; p < paths.count(); ++p)
            found[{paths.placement[p], paths.line_set[p]}] += paths.rows.size(p) - 1;
        return found;
    };
    LineSet of_second = line_set({"crease"});
    of_second.placements = {0, 1};
    using Found = std::map<std::pair<int, int>, int>;
    EXPECT_EQ(edges({of_second}), (Found{{{1, 0}, 12}}));
    EXPECT_EQ(edges({of_second, line_set({"crease"})}), (Found{{{0, 1}, 12}, {{1, 0}, 12}}));
    EXPECT_EQ(edges({line_set({"crease"}), of_second}), (Found{{{0, 0}, 12}, {{1, 0}, 12}}));
    of_second.placements = {1};
    EXPECT_THROW(edges({of_second}), std::invalid_argument);
}

TEST(Extract, IntersectionsAreForTheSetsOfTheirPlacement) {
    const auto surface = box().surface();
    const Scene scene({{surface, dmat4(1.0), 1}, {surface, moved({0.7, 0.6, 0.5}), 2}});
    const auto lines = [&](const std::vector<LineSet>& sets) {
        const Paths paths = extract(scene, corner_view, sets);
        std::map<int, int> found;
        for (Index p = 0; p < paths.count(); ++p) found[paths.line_set[p]] += paths.rows.size(p) - 1;
        return found;
    };
    LineSet first = line_set({"intersection"}), second = first;
    first.placements = {1, 0};
    second.placements = {0, 1};
    const LineSet all = line_set({"intersection"});
    const int count = lines({all}).at(0);
    ASSERT_GT(count, 0);
    const auto shared = lines({first, second});
    EXPECT_EQ((shared.contains(0) ? shared.at(0) : 0) + (shared.contains(1) ? shared.at(1) : 0), count);
    const auto left = lines({first, all});
    EXPECT_EQ((left.contains(0) ? left.at(0) : 0) + (left.contains(1) ? left.at(1) : 0), count);
}

TEST(Extract, KindsAreThoseOfTheSetThatHasTheEdge) {
    const Drawing drawing({place(box())}, corner_view, {line_set({"contour"}), line_set({"crease", "contour"})});
    for (Index p = 0; p < drawing.paths.count(); ++p)
        for (Index i = drawing.paths.rows.begin(p); i < drawing.paths.rows.end(p); ++i)
            EXPECT_EQ(drawing.paths.kinds[i], drawing.paths.line_set[p] == 0 ? bit_of("contour") : bit_of("crease"));
}

TEST(Extract, CachedLinesFollowTheParameters) {
    const Scene scene({place(sphere(16))});
    const auto creases = [&](double angle) {
        const Paths paths = extract(scene, corner_view, {line_set_with("crease", {angle, 1})});
        return paths.points_obj.size() - paths.count();
    };
    const std::size_t all = scene.placements[0].surface->mesh_edges;
    for (int repeat = 0; repeat < 2; ++repeat)
        for (const double angle : {0.0, 5.0, 11.5, 20.0, 90.0, 180.0}) {
            if (angle < 2) {
                EXPECT_EQ(creases(angle), all);
            }
            if (angle > 12) {
                EXPECT_EQ(creases(angle), 0u) << "neighbors differ by 11.25 degrees";
            }
            if (angle == 11.5) {
                EXPECT_LT(creases(angle), creases(5.0));
            }
        }
}

TEST(Extract, MovedVerticesGiveNewLines) {
    const Mesh flat = grid(2);
    const auto surface = flat.surface();
    const Scene scene({{surface, dmat4(1.0), 1}});
    const LineSet creases = line_set({"crease"});
    EXPECT_EQ(extract(scene, corner_view, {creases}).count(), 0u);
    std::vector<vec3> positions = flat.positions;
    for (vec3& p : positions) p.z = p.x < 0 ? 2.0f : 0.0f;
    surface->set_positions(positions);
    EXPECT_EQ(extract(scene, corner_view, {creases}).points_obj.size(), 3u) << "two edges, one path";
    surface->set_positions(flat.positions);
    EXPECT_EQ(extract(scene, corner_view, {creases}).count(), 0u);
}

TEST(Extract, OnlyWhatIsDrawnAndInTheFrame) {
    const auto surface = box().surface();
    const auto lines_of = [&](dmat4 at, int usage) {
        return extract(Scene({{surface, at, 1, std::uint8_t(usage)}}), corner_view, {line_set({"crease"})}).count();
    };
    EXPECT_EQ(lines_of(dmat4(1.0), usage_draw), 12u);
    EXPECT_EQ(lines_of(dmat4(1.0), usage_occlude), 0u);
    EXPECT_EQ(lines_of(dmat4(1.0), usage_holdout), 0u);
    EXPECT_EQ(lines_of(moved({100, 0, 0}), usage_draw), 0u);
    EXPECT_EQ(lines_of(moved({8, -10, 6}), usage_draw), 0u) << "behind the camera";
}

TEST(Extract, InstancesHaveTheirOwnContours) {
    // The second box is seen straight from its front.
    const auto surface = box().surface();
    const View view = perspective({0, -12, 0}, {0, 0, 0});
    const Drawing drawing({{surface, moved({3, 0, 3}), 1}, {surface, dmat4(1.0), 2}}, view, {line_set({"contour"})});
    EXPECT_EQ(drawing.lines(0).size(), 6u);
    EXPECT_EQ(drawing.lines(1).size(), 4u);
}

TEST(Extract, IsTheSameWithOneThreadAndMany) {
    Mesh mesh = sphere(80);
    mesh.material.resize(mesh.polygon_offsets.size() - 1);
    for (std::size_t f = 0; f < mesh.material.size(); ++f) mesh.material[f] = int(f / 37 % 3);
    const auto run = [&](std::size_t threads) {
        const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
        std::vector<Placement> placements;
        const auto surface = mesh.surface();
        for (int i = 0; i < 9; ++i)
            placements.push_back(
                {surface, moved({i % 3 - 1.0, i / 3 - 1.0, 0}) * scaled(dvec3(0.6)), std::uint64_t(i)});
        return extract(Scene(placements), corner_view,
                       {line_set({"contour", "silhouette"}), line_set({"material_boundary", "border"}, 30)});
    };
    const Paths one = run(1), many = run(8);
    EXPECT_GT(one.count(), 100u);
    expect_same_bits(one.rows.offsets, many.rows.offsets);
    expect_same_bits(one.id, many.id);
    expect_same_bits(one.points_obj, many.points_obj);
    expect_same_bits(one.place, many.place);
    expect_same_bits(one.edge_t, many.edge_t);
    expect_same_bits(one.kinds, many.kinds);
    expect_same_bits(one.closed, many.closed);
    expect_same_bits(one.line_set, many.line_set);
}

TEST(Extract, WhatIsTooShortForASampleIsLeftOutBeforeItTakesMemory) {
    // Boxes, smooth and flat, from some that fill the frame, partly outside and before the near plane, to far away.
    std::vector<Placement> placements;
    const auto box_surface = box().surface(), ball = sphere(12).surface();
    for (int i = 0; i < 400; ++i) {
        const double away = 0.3 * std::pow(1.03, i);
        placements.push_back({i % 3 ? box_surface : ball,
                              moved({0.4 * away * std::sin(i), away, 0.3 * away * std::cos(3 * i)}) *
                                  scaled(dvec3(0.1 + 0.02 * (i % 7), 0.2, 0.15)),
                              std::uint64_t(i)});
    }
    const Scene scene(placements);
    const std::vector<LineSet> sets{line_set({"contour", "smooth_contour", "border"}), line_set({"crease"}, 30)};
    for (const bool ortho : {false, true}) {
        const View view = ortho ? orthographic({0, 0, 0}, {0, 1, 0}, 60) : perspective({0, 0, 0}, {0, 1, 0});
        const Tracer tracer(scene, view);
        const ProjectOptions options{.sample_step_px = 2.5};
        const Paths all = extract_paths(scene, view, sets, tracer, Cancel());
        const Paths fewer = extract_paths(scene, view, sets, tracer, Cancel(), {}, options.sample_step_px);
        EXPECT_LT(fewer.count(), all.count() * 9 / 10);
        const ClippedPaths of_all = project::project(all, scene, view, options, Cancel());
        const ClippedPaths of_fewer = project::project(fewer, scene, view, options, Cancel());
        ASSERT_GT(of_all.path.size(), 200u);
        expect_same_bits(of_all.pieces.offsets, of_fewer.pieces.offsets);
        expect_same_bits(of_all.px, of_fewer.px);
        expect_same_bits(of_all.arc_px, of_fewer.arc_px);
        expect_same_bits(of_all.position_view, of_fewer.position_view);
        for (std::size_t i = 0; i < of_all.path.size(); ++i)
            ASSERT_EQ(all.id[of_all.path[i]], fewer.id[of_fewer.path[i]]);
    }
}

TEST(Extract, CanBeCancelled) {
    const Scene scene({place(box())});
    const Tracer tracer(scene, corner_view);
    Cancel cancel;
    cancel.requested = true;
    EXPECT_THROW(extract_paths(scene, corner_view, {line_set({"crease"})}, tracer, cancel), Cancelled);
}

TEST(Extract, ArcLengthsOfLinesOfTheMeshAreThoseOfTheRestShape) {
    // A slope whose columns of squares are pulled apart.
    constexpr int columns = 6;
    Mesh slope = grid(columns);
    for (vec3& p : slope.positions) p.z = 0.3f * p.y;
    const std::vector<vec3> at_rest = slope.positions;
    for (vec3& p : slope.positions) p.x += p.x * std::abs(p.x);
    const auto before = [&](const dvec3& point) {
        Index i = 0;
        while (i + 1 < columns && point.x > slope.positions[i + 1].x) ++i;
        const double from = slope.positions[i].x, to = slope.positions[i + 1].x;
        return dvec3(glm::mix(at_rest[i].x, at_rest[i + 1].x, (point.x - from) / (to - from)), point.y, point.z);
    };
    const auto pulled = slope.surface();
    const Scene scene({{pulled, dmat4(1.0), 1}});
    const auto found = [&] {
        return extract(scene, perspective({0.3, -0.2, 6}, {0, 0, 0}), {line_set({"border", "topographic"})});
    };
    const Paths as_it_is = found();
    pulled->set_rest(at_rest);
    const Paths paths = found();
    expect_same_bits(paths.points_obj, as_it_is.points_obj);
    std::set<Kinds> kinds;
    for (Index p = 0; p < paths.count(); ++p) {
        kinds.insert(paths.kinds[paths.rows.begin(p)]);
        double arc = 0.0;
        for (Index i = paths.rows.begin(p); i < paths.rows.end(p); ++i) {
            if (i > paths.rows.begin(p))
                arc += glm::distance(before(dvec3(paths.points_obj[i - 1])), before(dvec3(paths.points_obj[i])));
            EXPECT_NEAR(paths.arc_obj[i], arc, 1e-6) << p << " " << i;
        }
    }
    EXPECT_EQ(kinds, (std::set<Kinds>{bit_of("border"), bit_of("topographic")}));
    EXPECT_NE(paths.arc_obj, as_it_is.arc_obj);
    pulled->set_rest({});
    expect_same_bits(found().arc_obj, as_it_is.arc_obj);
}

TEST(Extract, RestPositionsThatDoNotFitAreRefusedAndThoseThatAreNoneCount) {
    const auto surface = box().surface();
    EXPECT_THROW(surface->set_rest(std::vector<vec3>(7)), std::invalid_argument);
    EXPECT_TRUE(surface->rest().empty());
    std::vector<vec3> broken(8, vec3(std::nanf("")));
    surface->set_rest(broken);
    for (const double arc : extract(Scene({{surface, dmat4(1.0), 1}}), corner_view, {line_set({"crease"})}).arc_obj)
        EXPECT_EQ(arc, 0.0);
}
