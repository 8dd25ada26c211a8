// SPDX-License-Identifier: GPL-3.0-or-later
// Section planes: lines whose length is known, what is cut away, and the inside.
#include <gtest/gtest.h>

#include <fovea/color/section_fill.h>
#include <fovea/scene/section.h>
#include <fovea/visibility/depth_image.h>

#include "intersections.h"

using namespace fovea;
using namespace fovea::draw;
using namespace fovea::intersections;

namespace {

constexpr dvec4 at_quarter{0.0, 0.0, 1.0, -0.25};  // z = 1/4; what is above is cut away
const View from_above = orthographic({0, 0, 9}, {0, 0, 0}, 6);
constexpr double px_per_unit = 640.0 / 6.0;

/// The section lines of a scene, in the world.
struct Cuts {
    std::vector<double> lengths;  // ascending
    std::vector<dvec3> at;
    std::vector<std::uint64_t> ids;
    Index closed = 0;

    Cuts(std::vector<Placement> placements, const dvec4& plane, const View& view = somewhere) {
        const Drawing drawing(std::move(placements), view, {line_set({"section_cut"})}, {}, plane);
        const Paths& paths = drawing.paths;
        for (Index p = 0; p < paths.count(); ++p) {
            const dmat4& to_world = drawing.scene.placements[paths.placement[p]].object_to_world;
            double length = 0.0;
            for (Index i = paths.rows.begin(p); i < paths.rows.end(p); ++i) {
                at.push_back(dvec3(to_world * dvec4(dvec3(paths.points_obj[i]), 1.0)));
                if (i > paths.rows.begin(p)) length += glm::distance(at.back(), at[at.size() - 2]);
            }
            lengths.push_back(length);
            ids.push_back(paths.id[p]);
            closed += paths.closed[p];
        }
        std::sort(lengths.begin(), lengths.end());
        for (const dvec3& p : at) EXPECT_NEAR(glm::dot(plane, dvec4(p, 1.0)), 0.0, 1e-5);
    }
};

double area_of(In<SectionSide> sides) {
    double area = 0.0;
    for (const auto& [from, to] : sides) area += 0.5 * (from.x * to.y - from.y * to.x);
    return area;
}

double area_of(std::vector<Placement> placements, const dvec4& plane, const View& view = from_above) {
    return area_of(section_sides(cut_open(std::move(placements), plane), view)) / (px_per_unit * px_per_unit);
}

}  // namespace

TEST(Section, OfACubeIsASquare) {
    const Cuts cut({put(box(), dmat4(1.0), 1)}, at_quarter);
    ASSERT_EQ(cut.lengths.size(), 1u);
    EXPECT_EQ(cut.closed, 1u);
    EXPECT_NEAR(cut.lengths[0], 8.0, 1e-5);
}

TEST(Section, OfACubeAcrossItsDiagonalIsARegularHexagon) {
    const dvec4 tilted = dvec4(1, 1, 1, 0) / std::sqrt(3.0);
    const Cuts cut({put(box(), dmat4(1.0), 1)}, tilted);
    ASSERT_EQ(cut.lengths.size(), 1u);
    EXPECT_EQ(cut.closed, 1u);
    EXPECT_NEAR(cut.lengths[0], 6.0 * std::sqrt(2.0), 1e-5);
}

TEST(Section, OfASphereIsACircle) {
    const int n = 48;
    const Cuts cut({put(sphere(n), moved({1, 2, 3}) * turned(0.7, {1, 2, 3}), 1)}, {0, 0, 1, -3.5});
    ASSERT_EQ(cut.lengths.size(), 1u);
    EXPECT_EQ(cut.closed, 1u);
    const double radius = std::sqrt(0.75), facet = 1.0 - std::cos(std::numbers::pi / n);
    EXPECT_NEAR(cut.lengths[0], 2 * std::numbers::pi * radius, 0.02);
    for (const dvec3& p : cut.at) EXPECT_NEAR(std::hypot(p.x - 1, p.y - 2), radius, 3 * facet);
}

TEST(Section, OfATorusIsTwoCirclesAcrossItAndAlongIt) {
    const Mesh ring = torus(2, 0.5, 64, 32);
    const double chord = 64 * 2 * std::sin(std::numbers::pi / 64), around = 32 * 2 * std::sin(std::numbers::pi / 32);
    const Cuts flat({put(ring, dmat4(1.0), 1)}, {0, 0, 1, 0}), upright({put(ring, dmat4(1.0), 1)}, {0, 1, 0, 0});
    ASSERT_EQ(flat.lengths.size(), 2u);
    EXPECT_EQ(flat.closed, 2u);
    EXPECT_NEAR(flat.lengths[0], 1.5 * chord, 1e-4);
    EXPECT_NEAR(flat.lengths[1], 2.5 * chord, 1e-4);
    ASSERT_EQ(upright.lengths.size(), 2u);
    EXPECT_EQ(upright.closed, 2u);
    for (const double length : upright.lengths) EXPECT_NEAR(length, 0.5 * around, 1e-4);
}

TEST(Section, OfInstancesHasLinesOfItsOwnForEachThatAreTheSameFromEverywhere) {
    const Placement one = put(box(), moved({-2, 0, 0}), 1);
    Placement other = one;
    other.object_to_world = moved({2, 0, 0.5});
    other.id = 2;
    const Cuts cut({one, other}, at_quarter), from_elsewhere({one, other}, at_quarter, from_above);
    EXPECT_EQ(cut.closed, 2u);
    ASSERT_EQ(cut.ids.size(), 2u);
    EXPECT_NE(cut.ids[0], cut.ids[1]);
    EXPECT_EQ(cut.ids, from_elsewhere.ids);
}

TEST(Section, KeepsAFaceInThePlaneAndOutlinesWhatStandsOnIt) {
    EXPECT_TRUE(Cuts({put(box(), dmat4(1.0), 1)}, {0, 0, 1, -1}).lengths.empty());
    const Cuts standing({put(box(), moved({0, 0, 2}), 1)}, {0, 0, 1, -1});
    ASSERT_EQ(standing.lengths.size(), 1u);
    EXPECT_NEAR(standing.lengths[0], 8.0, 1e-5);
}

TEST(Section, WhatIsCutAwayHidesNothingAndHasNoLines) {
    const Placement near = put(box(), moved({0, 0, 3}), 1), far = put(box(), moved({0.5, 0.5, -3}), 2);
    const View view = perspective({1, 2, 12}, {0, 0, 0}, 40);
    const Drawing alone({far}, view, {all_edges()}), whole({near, far}, view, {all_edges()}),
        cut({near, far}, view, {all_edges()}, {}, at_quarter);
    EXPECT_LT(whole.visible_px(1), 0.9 * alone.visible_px(0));
    EXPECT_NEAR(cut.visible_px(1), alone.visible_px(0), 1e-6);
    EXPECT_EQ(cut.total_px(0), 0.0);
}

TEST(Section, LinesEndAtThePlane) {
    const Drawing cut({put(box(), dmat4(1.0), 1)}, orthographic({0, -9, 0}, {0, 0, 0}, 6), {all_edges()}, {},
                      at_quarter);
    float highest = -1e9f;
    for (const vec3& p : cut.clipped.position_view) highest = std::max(highest, p.y);
    EXPECT_NEAR(highest, 0.25, 1e-5);
}

TEST(Section, OpensABoxSoThatItsFloorIsSeenButNotWhatASolidHasInside) {
    Mesh open("open", box().positions);  // a box without its lid
    const Mesh closed = box();
    for (std::size_t f = 0; f + 1 < closed.polygon_offsets.size(); ++f) {
        const std::vector<int> verts(closed.corner_verts.begin() + closed.polygon_offsets[f],
                                     closed.corner_verts.begin() + closed.polygon_offsets[f + 1]);
        if (std::ranges::any_of(verts, [&](int v) { return closed.positions[v].z < 0.0f; })) open.add_polygon(verts);
    }
    const View view = perspective({0, 0, 8}, {0, 0, 0}, 40);
    const auto on_floor = [&](const Mesh& mesh) {  // visible pixels of lines on the floor
        const Drawing drawing({put(mesh, dmat4(1.0), 1)}, view, {line_set({"crease"})}, {}, at_quarter);
        double seen = 0.0;
        for (Index r = 0; r < drawing.runs.size(); ++r) {
            const Index first = drawing.clipped.pieces.begin(drawing.runs.piece[r]);
            const float z = drawing.clipped.position_view[first].z, next = drawing.clipped.position_view[first + 1].z;
            if (std::max(z, next) < -8.99f) seen += drawing.runs.end_px[r] - drawing.runs.start_px[r];
        }
        return seen;
    };
    const double side = glm::distance(pixel_of(view, {-1, -1, -1}), pixel_of(view, {1, -1, -1}));
    EXPECT_NEAR(on_floor(open), 4 * side, 0.5);
    EXPECT_EQ(on_floor(closed), 0.0);
}

TEST(Section, OutsideOfAllObjectsChangesNothing) {
    const std::vector<Placement> placed{put(sphere(24), moved({0, 0, 0.5}), 1), put(box(), turned(0.4, {1, 2, 3}), 2)};
    const std::vector<LineSet> sets{line_set({"contour", "crease", "intersection", "suggestive_contour"})};
    const Drawing whole(placed, somewhere, sets), cut(placed, somewhere, sets, {}, dvec4(0, 0, 1, -5));
    ASSERT_GT(whole.runs.size(), 0u);
    EXPECT_EQ(whole.paths.points_obj, cut.paths.points_obj);
    EXPECT_EQ(whole.paths.id, cut.paths.id);
    EXPECT_EQ(whole.clipped.px, cut.clipped.px);
    EXPECT_EQ(whole.runs.piece, cut.runs.piece);
    EXPECT_EQ(whole.runs.start_px, cut.runs.start_px);
    EXPECT_EQ(whole.runs.end_px, cut.runs.end_px);
    EXPECT_EQ(depth_image(whole.tracer, Cancel()), depth_image(cut.tracer, Cancel()));
}

TEST(Section, RaysAndTheRasterizerSeeTheSame) {
    const std::vector<Placement> placed{put(sphere(24), moved({0, 0, 0.5}), 1), put(box(), turned(0.4, {1, 2, 3}), 2),
                                        put(grid(3, 4), moved({0, 0, -2}), 3)};
    const dvec4 tilted = dvec4(1, -2, 3, -1) / std::sqrt(14.0);
    for (const View& view :
         {perspective({3, -5, 7}, {0, 0, 0}, 30, 160, 120), orthographic({3, -5, 7}, {0, 0, 0}, 7, 160, 120)}) {
        const Scene scene = cut_open(placed, tilted);
        const Tracer tracer(scene, view);
        const Array<float> depth = depth_image(tracer, Cancel());
        int other = 0;
        for (int y = 0; y < view.height; ++y)
            for (int x = 0; x < view.width; ++x) {
                const auto hit = tracer.seen({x + 0.5, y + 0.5});
                const double by_ray = hit ? hit->t : double(background_depth), drawn = depth[y * view.width + x];
                other += std::abs(by_ray - drawn) > 1e-4 * by_ray;
            }
        EXPECT_LE(other, 8) << "pixels, at edges";
    }
}

TEST(SectionInside, HasTheAreaOfWhatIsCut) {
    EXPECT_NEAR(area_of({put(box(), dmat4(1.0), 1)}, at_quarter), 4.0, 1e-5);
    EXPECT_NEAR(area_of({put(box(), scaled({-1, 1, 1}), 1)}, at_quarter), 4.0, 1e-5) << "mirrored";
    EXPECT_NEAR(area_of({put(intersections::split(box()), dmat4(1.0), 1)}, at_quarter), 4.0, 1e-5) << "split";
    const double sector = 64 * 0.5 * std::sin(2 * std::numbers::pi / 64);
    EXPECT_NEAR(area_of({put(torus(2, 0.5, 64, 32), dmat4(1.0), 1)}, {0, 0, 1, 0}), (6.25 - 2.25) * sector, 1e-4);
    EXPECT_EQ(area_of({put(grid(3, 4), turned(1.0, {1, 0, 0}), 1)}, at_quarter), 0.0) << "an open surface has none";
    EXPECT_EQ(area_of({put(box(), dmat4(1.0), 1)}, {0, 0, -1, -0.25}), 0.0) << "seen from behind";
}

TEST(SectionInside, IsFilledOnceWhereSolidsOverlap) {
    const std::vector<Placement> two{put(box(), dmat4(1.0), 1), put(box(), moved({1, 0.5, 0}), 2)};
    Array<vec4> pixels(640 * 480, vec4(0.0f));
    color::fill_section(section_sides(cut_open(two, at_quarter), from_above), from_above, vec3(0.5f), pixels);
    double sum = 0.0;
    for (const vec4& pixel : pixels) {
        sum += pixel.a;
        EXPECT_LE(pixel.a, 1.0f + 1e-6f);
        EXPECT_NEAR(pixel.r, 0.5f * pixel.a, 1e-6f);
    }
    EXPECT_NEAR(sum / (px_per_unit * px_per_unit), 4.0 + 4.0 - 1.5, 1e-2);
}

TEST(SectionInside, IsHatchedAtASpacing) {
    View view = from_above;
    view.reference_scale = 1.0;
    const double spacing = 5.0;
    const Drawing drawing({put(torus(2, 0.5, 64, 32), dmat4(1.0), 1)}, view,
                          {line_set_with("section_hatch", {30.0, spacing})}, {.least_length_px = {200.0}},
                          dvec4(0, 0, 1, 0));
    ASSERT_GT(drawing.paths.count(), 50u);
    double length = 0.0;
    for (Index r = 0; r < drawing.runs.size(); ++r) length += drawing.runs.end_px[r] - drawing.runs.start_px[r];
    const double area = area_of(section_sides(drawing.scene, view));
    EXPECT_NEAR(length * spacing, area, 0.01 * area);
    const std::set<std::uint64_t> ids(drawing.paths.id.begin(), drawing.paths.id.end());
    EXPECT_EQ(ids.size(), drawing.paths.count());
    for (const dvec3 p : drawing.clipped.position_view) {
        const double radius = std::hypot(p.x, p.y);
        EXPECT_GT(radius, 1.5 - 0.01);
        EXPECT_LT(radius, 2.5 + 0.01);
    }
}
