// SPDX-License-Identifier: GPL-3.0-or-later
// Line sets by light: where lines are cut, and whose the parts are.
#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <fovea/draw/frame.h>
#include <fovea/style/json.h>

#include "analytic.h"
#include "shadows.h"

using namespace fovea;
using namespace fovea::draw;
using namespace fovea::drawing;
using namespace fovea::meshes;
using namespace fovea::shadows;

namespace {

const dvec3 slanted = glm::normalize(dvec3(0.5, -0.3, 1.0));
const View from_afar = perspective({9, -14, 11}, {0, 0, 0.8}, 60.0, 800, 600);

/// A line set with these definitions, as JSON.
std::string set_of(const std::string& kinds, const std::string& light = "any", const std::string& more = "") {
    return R"({"name": ")" + light + R"(", "kinds": {)" + kinds + R"(}, "light": ")" + light +
           R"(", "least_length": 0, "corner_angle": 180)" + more + "}";
}

std::string style_of(const std::vector<std::string>& sets) {
    std::string all;
    for (const std::string& set : sets) all += (all.empty() ? "" : ", ") + set;
    return R"({"schema": 1, "line_sets": [)" + all + "]}";
}

/// Without what filters take away for the looks of it.
Options exactly() {
    Options options;
    options.gap = options.spur = options.contour_spur = options.fold = options.tip = 0.0;
    return options;
}

Frame drawn(std::vector<Placement> placements, std::vector<Light> lights, const View& view,
            const std::vector<std::string>& sets, const std::vector<Overrides::Filter>& filters = {}) {
    auto scene = std::make_shared<Scene>(Scene(std::move(placements)));
    scene->lights = std::move(lights);
    Job job{.scene = scene,
            .view = view,
            .style = style::read_style(style_of(sets)),
            .options = exactly(),
            .assets = std::make_shared<Assets>("."),
            .backend = std::make_shared<CpuBackend>()};
    job.overrides.line_sets = filters;
    Frame frame(std::move(job));
    frame.filter();
    return frame;
}

double length(const Frame& frame, int set = -1) {
    double sum = 0.0;
    for (std::size_t r = 0; r < frame.runs->size(); ++r)
        if (set < 0 || frame.paths->line_set[frame.clipped->path[frame.runs->piece[r]]] == set)
            sum += frame.runs->end_px[r] - frame.runs->start_px[r];
    return sum;
}

/// Where runs of a set are cut, not at the ends of their pieces: pixels.
std::vector<dvec2> cuts(const Frame& frame, int set) {
    std::vector<dvec2> found;
    for (std::size_t r = 0; r < frame.runs->size(); ++r) {
        const Index q = frame.runs->piece[r];
        if (frame.paths->line_set[frame.clipped->path[q]] != set) continue;
        for (const double arc : {frame.runs->start_px[r], frame.runs->end_px[r]})
            if (arc > frame.clipped->first_arc(q) + 1e-6 && arc < frame.clipped->last_arc(q) - 1e-6)
                found.push_back(frame.clipped->place_px(q, arc));
    }
    return found;
}

Placement smooth_sphere(int n, const dmat4& to_world = dmat4(1.0), std::uint64_t id = 1) {
    Mesh mesh = sphere(n);
    mesh.shape = Shape::smooth;
    return place(mesh, to_world, id);
}

/// A torus and a box over a floor of squares, all of whose edges are marked.
std::vector<Placement> things() {
    Mesh squares = grid(12, 6.0f);
    squares.edge_mark.assign(squares.edge_verts.size(), 1);
    return {place(analytic::torus({.n = 32}).mesh, glm::rotate(moved({0, 0, 2}), 0.9, dvec3(1, 0.3, 0.2)), 1),
            place(box(), moved({-2.1, 1.13, 1}), 2), place(squares, dmat4(1.0), 3)};
}

const std::string lines = R"("contour": {}, "crease": {}, "edge_mark": {})";
const std::vector<Light> two_lights = {sun(slanted), lamp({5, -2, 9}, 30.0f, 2)};

}  // namespace

TEST(ByLight, AGreatCircleIsLitByHalf) {
    const View view = orthographic({0, -10, 0}, {0, 0, 0}, 2.5, 800, 800);
    const dvec3 towards = glm::normalize(dvec3(1.0, -0.4, 0.7));
    const Frame frame = drawn({smooth_sphere(64)}, {sun(towards)}, view,
                              {set_of(R"("smooth_contour": {})", "lit"), set_of(R"("smooth_contour": {})", "shaded")});
    EXPECT_NEAR(length(frame, 0) / length(frame, 1), 1.0, 1e-3);
    EXPECT_NEAR(length(frame), 2 * std::numbers::pi * 320, 2.0);
    const dvec3 end = glm::normalize(glm::cross(towards, dvec3(0, 1, 0)));
    const dvec2 a = pixel_of(view, end), b = pixel_of(view, -end);
    // Along the circle, whatever the mesh is beside it.
    const dvec2 center = pixel_of(view, dvec3(0.0));
    const auto along = [&](const dvec2& px, const dvec2& at) {
        return glm::dot(px - center, at - center) < 0.0
                   ? 1e9
                   : std::abs(base::cross(px - center, glm::normalize(at - center)));
    };
    for (const int set : {0, 1}) {
        const std::vector<dvec2> found = cuts(frame, set);
        ASSERT_GE(found.size(), 2u);
        for (const dvec2& px : found)
            EXPECT_LT(std::min(along(px, a), along(px, b)), visibility::exact_tolerance_px + 0.01);
    }
}

TEST(ByLight, TheShadowOfASphereCutsLinesOfTheFloorWhereTheEllipseSays) {
    const dvec3 c(0.3, 0.2, 2.5);
    Mesh squares = grid(30, 6.0f);
    squares.edge_mark.assign(squares.edge_verts.size(), 1);
    const Frame frame = drawn({smooth_sphere(96, moved(c)), place(squares, dmat4(1.0), 3)}, {sun(slanted)}, from_afar,
                              {set_of(R"("edge_mark": {})", "lit"), set_of(R"("edge_mark": {})", "cast")});
    const dmat4 to_floor = glm::inverse(from_afar.view_to_clip * from_afar.world_to_view);
    const auto on_floor = [&](const dvec2& px) {
        const dvec2 ndc(2.0 * px.x / from_afar.width - 1.0, 2.0 * px.y / from_afar.height - 1.0);
        dvec4 near = to_floor * dvec4(ndc, -1, 1), far = to_floor * dvec4(ndc, 1, 1);
        const dvec3 from = dvec3(near) / near.w, to = dvec3(far) / far.w;
        return glm::mix(from, to, from.z / (from.z - to.z));
    };
    int at_ellipse = 0;
    for (const dvec2& px : cuts(frame, 1)) {
        const dvec3 from = on_floor(px) - c;
        const double passes = glm::length(from - glm::dot(from, slanted) * slanted);
        if (glm::length(from) > 20.0) continue;
        // What a pixel is there in the scene, at most; where lines go behind the sphere they are cut, too.
        if (std::abs(passes - 1.0) < 0.003) ++at_ellipse;
    }
    EXPECT_GE(at_ellipse, 15);
    const dvec2 middle = pixel_of(from_afar, c);
    const double radius = glm::distance(middle, pixel_of(from_afar, c + dvec3(0, 0, 1))) * 1.15;
    for (const int set : {0, 1})
        for (const dvec2& px : cuts(frame, set)) {
            const dvec3 from = on_floor(px) - c;
            const double passes = glm::length(from - glm::dot(from, slanted) * slanted);
            if (glm::distance(px, middle) > radius) {
                EXPECT_NEAR(passes, 1.0, 0.003) << px.x << " " << px.y;
            }
        }
}

TEST(ByLight, LitAndShadedPartsAreAllOfTheLines) {
    const Frame all = drawn(things(), two_lights, from_afar, {set_of(lines)}),
                parts = drawn(things(), two_lights, from_afar, {set_of(lines, "lit"), set_of(lines, "shaded")}),
                thirds = drawn(things(), two_lights, from_afar,
                               {set_of(lines, "attached"), set_of(lines, "lit"), set_of(lines, "cast")});
    EXPECT_NEAR(length(parts), length(all), 1e-6 * length(all));
    EXPECT_NEAR(length(thirds), length(all), 1e-6 * length(all));
    EXPECT_NEAR(length(thirds, 1), length(parts, 0), 1e-6 * length(all));
    for (const int set : {0, 1}) EXPECT_GT(length(parts, set), 0.03 * length(all));
    for (const int set : {0, 1, 2}) EXPECT_GT(length(thirds, set), 0.02 * length(all)) << set;
    const Frame lit = drawn(things(), two_lights, from_afar, {set_of(lines, "lit")});
    EXPECT_NEAR(length(lit), length(parts, 0), 1e-6 * length(all));
    EXPECT_EQ(lit.paths->count(), all.paths->count());
}

TEST(ByLight, AnySetTakesWhatSetsBeforeItLeave) {
    const Frame all = drawn(things(), two_lights, from_afar, {set_of(lines)}),
                first = drawn(things(), two_lights, from_afar, {set_of(lines, "shaded"), set_of(lines)}),
                last = drawn(things(), two_lights, from_afar, {set_of(lines), set_of(lines, "shaded")});
    EXPECT_NEAR(length(first), length(all), 1e-6 * length(all));
    for (const int set : {0, 1}) EXPECT_GT(length(first, set), 0.03 * length(all));
    EXPECT_EQ(length(last, 1), 0.0);
    EXPECT_EQ(last.runs->start_px, all.runs->start_px);
}

TEST(ByLight, SetsOfSomeObjectsShareWithThoseOfAll) {
    // Shaded lines of the box are of the first set, all other lines of the second.
    Overrides::Filter of_box, of_all;
    of_box.placements = {0, 1, 0};
    const Frame frame = drawn(things(), two_lights, from_afar,
                              {set_of(R"("crease": {}, "contour": {})", "shaded"), set_of(lines)}, {of_box, of_all}),
                all = drawn(things(), two_lights, from_afar, {set_of(lines)});
    EXPECT_NEAR(length(frame), length(all), 1e-6 * length(all));
    double of_set = 0.0, others = 0.0;
    for (std::size_t r = 0; r < frame.runs->size(); ++r) {
        const Index path = frame.clipped->path[frame.runs->piece[r]];
        if (frame.paths->line_set[path] != 0) continue;
        const double px = frame.runs->end_px[r] - frame.runs->start_px[r];
        (frame.paths->placement[path] == 1 ? of_set : others) += px;
    }
    EXPECT_GT(of_set, 20.0);
    EXPECT_EQ(others, 0.0);
}

TEST(ByLight, WithoutAFilterNothingChangesAndNoRayIsCast) {
    const Frame any = drawn(things(), two_lights, from_afar, {set_of(lines)}),
                dark = drawn(things(), {}, from_afar, {set_of(lines)});
    EXPECT_EQ(any.runs->start_px, dark.runs->start_px);
    EXPECT_EQ(any.paths->id, dark.paths->id);
    const Frame lit = drawn(things(), {}, from_afar, {set_of(lines, "lit"), set_of(lines, "shaded")});
    EXPECT_EQ(lit.runs->end_px, any.runs->end_px);  // without lights all is lit
    EXPECT_EQ(length(lit, 1), 0.0);
}

TEST(ByLight, CopiesHaveIdsAndSamplesOfTheirOwn) {
    const Frame frame = drawn(things(), two_lights, from_afar, {set_of(lines, "lit"), set_of(lines, "shaded")});
    const std::set<std::uint64_t> ids(frame.paths->id.begin(), frame.paths->id.end());
    EXPECT_EQ(ids.size(), frame.paths->id.size());
    const ClippedPaths& clipped = *frame.clipped;
    Index samples = 0;
    for (Index q = 0; q < clipped.pieces.count(); ++q)
        for (Index i = clipped.pieces.begin(q); i < clipped.pieces.end(q); ++i) {
            EXPECT_EQ(clipped.sample_start[i], samples);
            samples += clipped.sample_count[i];
        }
    EXPECT_EQ(clipped.samples, samples);
    for (Index q = 0; q < clipped.pieces.count(); ++q)
        for (Index i = clipped.pieces.begin(q); i < clipped.pieces.end(q); ++i) {
            EXPECT_GE(clipped.source[i], frame.paths->rows.begin(clipped.path[q]));
            EXPECT_LT(clipped.source[i], frame.paths->rows.end(clipped.path[q]));
        }
    EXPECT_TRUE(std::ranges::is_sorted(clipped.path));
    EXPECT_TRUE(std::ranges::is_sorted(frame.runs->piece));
}

TEST(ByLight, IsTheSameWithOneAndManyThreadsAndWhereverTheSceneIs) {
    const std::vector<std::string> sets = {set_of(lines, "lit"), set_of(lines, "shaded")};
    const Frame many = drawn(things(), two_lights, from_afar, sets);
    {
        tbb::global_control one(tbb::global_control::max_allowed_parallelism, 1);
        const Frame alone = drawn(things(), two_lights, from_afar, sets);
        EXPECT_EQ(many.runs->start_px, alone.runs->start_px);
        EXPECT_EQ(many.runs->piece, alone.runs->piece);
        EXPECT_EQ(many.paths->id, alone.paths->id);
    }
    const dmat4 motion = glm::rotate(moved({5, -3, 2}) * scaled(dvec3(2.5)), 1.1, dvec3(0.2, 1, 0.4));
    std::vector<Placement> placements = things();
    for (Placement& placement : placements) placement.object_to_world = motion * placement.object_to_world;
    std::vector<Light> lights = two_lights;
    for (Light& light : lights) {
        light.position = dvec3(motion * dvec4(light.position, 1.0));
        light.direction = dmat3(motion) * light.direction;
    }
    View view = from_afar;
    view.world_to_view = scaled(dvec3(2.5)) * view.world_to_view * glm::inverse(motion);
    view.near_clip *= 2.5;
    const Frame turned = drawn(placements, lights, view, sets);
    for (const int set : {0, 1}) EXPECT_NEAR(length(turned, set), length(many, set), 1e-3 * length(many));
}

TEST(ByLight, TheFootOfAWallIsAsTheFloorBesideItIs) {
    // A wall that stands on the floor, and shares its edge: light comes from behind it.
    const Mesh corner = of_polygons("corner", {{-3, 0, 0}, {3, 0, 0}, {3, -3, 0}, {-3, -3, 0}, {-3, 0, 3}, {3, 0, 3}},
                                    {{0, 3, 2, 1}, {0, 1, 5, 4}});
    const View view = perspective({1, -12, 6}, {0, 0, 0.5}, 40.0, 800, 600);
    const std::vector<std::string> sets = {set_of(R"("crease": {})", "lit"), set_of(R"("crease": {})", "cast"),
                                           set_of(R"("crease": {})", "attached")};
    const Frame behind = drawn({place(corner)}, {sun({0.1, 1, 1})}, view, sets),
                before = drawn({place(corner)}, {sun({0.1, -1, 1})}, view, sets);
    EXPECT_GT(length(behind, 1), 100.0);
    EXPECT_NEAR(length(behind, 1), length(behind), 1.0);
    EXPECT_NEAR(length(before, 0), length(before), 1.0);
}

TEST(ByLight, TheContourOfAnOpenShellIsOfTheSideThatOneSees) {
    // A tube without ends, of either winding: seen from outside its contour is as the outside is there.
    const View view = perspective({0.5, -12, 0.3}, {0, 0, 0}, 50.0, 800, 600);
    for (const Shape shape : {Shape::hard, Shape::smooth})
        for (const bool inward : {false, true}) {
            Mesh tube = flipped(cylinder(24), [&](int) { return inward; });
            tube.shape = shape;
            const std::string kind = shape == Shape::smooth ? R"("smooth_contour": {})" : R"("contour": {})";
            const Frame frame = drawn({place(tube)}, {sun({1, -0.3, 0})}, view,
                                      {set_of(kind, "lit"), set_of(kind, "attached"), set_of(kind, "cast")});
            EXPECT_GT(length(frame, 0), 100.0);
            EXPECT_NEAR(length(frame, 0) / length(frame, 1), 1.0, 0.05);
            EXPECT_EQ(length(frame, 2), 0.0);
        }
}

TEST(ByLight, OutlinesOfShadowsAreInShade) {
    const std::string outlines = R"("cast_shadow": {}, "light_contour": {})";
    const Frame frame = drawn(things(), two_lights, from_afar, {set_of(outlines, "lit"), set_of(outlines, "shaded")});
    EXPECT_GT(length(frame, 1), 100.0);
    EXPECT_EQ(length(frame, 0), 0.0);
}
