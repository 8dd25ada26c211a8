// SPDX-License-Identifier: GPL-3.0-or-later
// What line sets, objects and materials leave out: filters by placement and material, and lines of placements' own.
#include <cmath>
#include <cstring>
#include <gtest/gtest.h>
#include <limits>
#include <set>
#include <tbb/global_control.h>

#include "drawing.h"

using namespace fovea;
using namespace fovea::draw;
using namespace fovea::meshes;
using namespace fovea::drawing;

namespace {

constexpr double as_the_set_says = std::numeric_limits<double>::quiet_NaN();

Paths extract(const Scene& scene, const std::vector<LineSet>& sets, const OwnLines& own = {}) {
    const Tracer tracer(scene, corner_view);
    return extract_paths(scene, corner_view, sets, tracer, Cancel(), own);
}

/// A box whose top (polygon 1) has material 1.
Mesh capped_box() {
    Mesh mesh = box();
    mesh.material = {0, 1, 0, 0, 0, 0};
    return mesh;
}

/// A sphere whose lower half has material 1.
Mesh two_halves(int n) {
    Mesh mesh = sphere(n);
    for (std::size_t f = 0; f + 1 < mesh.polygon_offsets.size(); ++f) {
        float z = 0.0f;
        for (int c = mesh.polygon_offsets[f]; c < mesh.polygon_offsets[f + 1]; ++c)
            z += mesh.positions[mesh.corner_verts[c]].z;
        mesh.material.push_back(z < 0.0f);
    }
    return mesh;
}

LineSet of_material(LineSet set, std::vector<std::uint8_t> mask, std::size_t placements = 1) {
    set.materials = {std::vector<Index>(placements, 0), {std::move(mask)}};
    return set;
}

/// (place, kinds) of all segments, by line set.
using Segments = std::map<int, std::set<std::pair<Index, Kinds>>>;
Segments segments(const Paths& paths) {
    Segments found;
    for (Index p = 0; p < paths.count(); ++p)
        for (Index i = paths.rows.begin(p); i + 1 < paths.rows.end(p); ++i)
            found[paths.line_set[p]].insert({paths.place[i], paths.kinds[i]});
    return found;
}

int material_at(const Surface& surface, Index place) {
    return material_of_triangle(surface, surface.triangle_at(place));
}

/// Edges by (placement, line set).
using Counts = std::map<std::pair<int, int>, int>;
Counts counts(const Paths& paths) {
    Counts found;
    for (Index p = 0; p < paths.count(); ++p)
        found[{static_cast<int>(paths.placement[p]), paths.line_set[p]}] += static_cast<int>(paths.rows.size(p)) - 1;
    return found;
}

}  // namespace

TEST(Filters, AnEdgeIsOfTheMaterialsOfBothItsFaces) {
    const Scene scene({place(capped_box())});
    const LineSet creases = line_set({"crease"});
    EXPECT_EQ(counts(extract(scene, {of_material(creases, {0, 1})})), (Counts{{{0, 0}, 4}})) << "around the top";
    EXPECT_EQ(counts(extract(scene, {of_material(creases, {1, 0})})), (Counts{{{0, 0}, 12}})) << "the sides have all";
    EXPECT_EQ(counts(extract(scene, {of_material(creases, {1, 1})})), (Counts{{{0, 0}, 12}}));
    EXPECT_TRUE(counts(extract(scene, {of_material(creases, {0, 0})})).empty());
    const LineSet boundary = line_set({"material_boundary"});
    EXPECT_EQ(counts(extract(scene, {of_material(boundary, {0, 1})})), (Counts{{{0, 0}, 4}}));
    EXPECT_EQ(counts(extract(scene, {of_material(boundary, {1, 0})})), (Counts{{{0, 0}, 4}}));
}

TEST(Filters, TheFirstSetThatHasAnEdgesMaterialHasTheEdge) {
    const Scene scene({place(capped_box())});
    const LineSet creases = line_set({"crease"});
    const LineSet top = of_material(creases, {0, 1}), sides = of_material(creases, {1, 0});
    EXPECT_EQ(counts(extract(scene, {top, sides})), (Counts{{{0, 0}, 4}, {{0, 1}, 8}}));
    EXPECT_EQ(counts(extract(scene, {sides, top})), (Counts{{{0, 0}, 12}}));
    EXPECT_EQ(counts(extract(scene, {top, creases})), (Counts{{{0, 0}, 4}, {{0, 1}, 8}}));
}

TEST(Filters, CurvesAreDividedWhereTheMaterialChanges) {
    const auto surface = two_halves(24).surface();
    const Scene scene({{surface, dmat4(1.0), 1}});
    for (const char* name : {"smooth_contour", "topographic", "smooth_silhouette"}) {
        const LineSet all = line_set({name});
        const auto whole = segments(extract(scene, {all})).at(0);
        auto shared = segments(extract(scene, {of_material(all, {0, 1}), all}));
        ASSERT_FALSE(shared[0].empty()) << name;
        ASSERT_FALSE(shared[1].empty()) << name;
        for (int set : {0, 1})
            for (const auto& [place, kinds] : shared[set]) EXPECT_EQ(material_at(*surface, place), 1 - set) << name;
        shared[0].merge(shared[1]);
        EXPECT_EQ(shared[0], whole) << name << ": nothing is lost, and nothing drawn twice";
        EXPECT_EQ(segments(extract(scene, {all, of_material(all, {0, 1})})), (Segments{{0, whole}})) << name;
    }
}

TEST(Filters, OtherParametersOfAnotherMaterialAreItsOwn) {
    const auto surface = two_halves(24).surface();
    const Scene scene({{surface, dmat4(1.0), 1}});
    const LineSet few = line_set_with("isophote", {3}), many = line_set_with("isophote", {9});
    const auto of_few = segments(extract(scene, {few})).at(0), of_many = segments(extract(scene, {many})).at(0);
    ASSERT_NE(of_few, of_many);
    auto shared = segments(extract(scene, {of_material(few, {0, 1}), many}));
    for (const auto& segment : of_few)
        EXPECT_EQ(shared[0].contains(segment), material_at(*surface, segment.first) == 1);
    for (const auto& segment : of_many)
        EXPECT_EQ(shared[1].contains(segment), material_at(*surface, segment.first) == 0);
}

TEST(Filters, ContoursOfEdgesStayWhereTheSmoothOneIsForAnotherMaterial) {
    const auto surface = two_halves(24).surface();
    const Scene scene({{surface, dmat4(1.0), 1}});
    const LineSet edges = of_material(line_set({"contour"}), {1, 0});
    const LineSet smooth = of_material(line_set({"smooth_contour"}), {0, 1});
    const auto alone = segments(extract(scene, {edges})).at(0);
    auto both = segments(extract(scene, {edges, smooth}));
    ASSERT_FALSE(both[1].empty());
    // Where the materials meet, edges have both.
    int left = 0;
    for (const auto& [place, kinds] : both[0]) {
        EXPECT_TRUE(alone.contains({place, kinds}));
        ++left;
    }
    int inside = 0;
    for (const auto& [place, kinds] : alone)
        inside += !any_beside(*surface, place, [](int material) { return material == 1; });
    EXPECT_GE(left, inside);
    EXPECT_GT(inside, 10);
    const auto everywhere = segments(extract(scene, {line_set({"contour"}), line_set({"smooth_contour"})}));
    EXPECT_FALSE(everywhere.contains(0)) << "one line where both are asked for";
}

TEST(Filters, IntersectionsAreForSetsOfEitherPlacement) {
    const auto surface = box().surface();
    const Scene scene({{surface, dmat4(1.0), 1}, {surface, moved({0.7, 0.6, 0.5}), 2}});
    const LineSet all = line_set({"intersection"});
    LineSet first = all, second = all;
    first.placements = {1, 0};
    second.placements = {0, 1};
    const auto whole = segments(extract(scene, {all})).at(0);
    EXPECT_EQ(segments(extract(scene, {first})), (Segments{{0, whole}}));
    EXPECT_EQ(segments(extract(scene, {second, first})), (Segments{{0, whole}}));
    const OwnLines hidden{.kinds = {~Kinds(0), ~bit_of("intersection")}};
    EXPECT_TRUE(segments(extract(scene, {all}, hidden)).empty()) << "both must show it";
}

TEST(Filters, IntersectionsOfOtherShapesAreLeftToTheNextSet) {
    const Scene scene({place(box()), place(box(), moved({0.7, 0.6, 0.5}), 2)});
    const LineSet all = line_set({"intersection"});
    LineSet smooth = all, hard = all;
    smooth.surfaces = Surfaces::smooth;
    hard.surfaces = Surfaces::hard;
    const auto whole = segments(extract(scene, {all})).at(0);
    EXPECT_EQ(segments(extract(scene, {smooth, all})), (Segments{{1, whole}}));
    EXPECT_EQ(segments(extract(scene, {hard, all})), (Segments{{0, whole}}));
}

TEST(Filters, IntersectionsAreOfTheMaterialsOfBothFaces) {
    const Scene scene({place(capped_box(), dmat4(1.0), 1), place(box(), moved({0.7, 0.6, 1.0}), 2)});
    const LineSet all = line_set({"intersection"});
    LineSet top = all;
    top.materials = {{0, 1}, {{0, 1}, {0}}};
    const auto whole = segments(extract(scene, {all})).at(0);
    auto shared = segments(extract(scene, {top, all}));
    ASSERT_FALSE(shared[0].empty());
    ASSERT_FALSE(shared[1].empty());
    auto sum = shared[0];
    sum.insert(shared[1].begin(), shared[1].end());
    EXPECT_EQ(sum, whole);
    EXPECT_EQ(shared[0].size() + shared[1].size(), whole.size());
}

TEST(Filters, LinesOfTheImageAreForSetsOfAllAlone) {
    const Scene scene({place(capped_box())});
    const LineSet image = line_set({"image_edge"});
    EXPECT_FALSE(counts(extract(scene, {image})).empty());
    EXPECT_TRUE(counts(extract(scene, {of_material(image, {0, 1})})).empty());
    const OwnLines capped{.materials = {{0}, {{1, 0}}}};
    EXPECT_FALSE(counts(extract(scene, {image}, capped)).empty()) << "they are of no material";
}

TEST(OwnLines, APlacementShowsItsKindsAlone) {
    const auto surface = box().surface();
    const Scene scene({{surface, moved({-1.5, 0, 0}), 1}, {surface, moved({1.5, 0, 0}), 2}});
    const OwnLines own{.kinds = {bit_of("contour"), ~Kinds(0)}};
    EXPECT_EQ(counts(extract(scene, {line_set({"crease"})}, own)), (Counts{{{1, 0}, 12}}));
    const auto both = counts(extract(scene, {line_set({"crease"}), line_set({"contour"})}, own));
    EXPECT_EQ(both, (Counts{{{0, 1}, 6}, {{1, 0}, 12}})) << "the next set that has the edge draws it";
    EXPECT_THROW(extract(scene, {line_set({"crease"})}, OwnLines{.kinds = {0}}), std::invalid_argument);
}

TEST(OwnLines, CreasesHaveTheAngleOfTheirPlacement) {
    const auto surface = box().surface();
    const Scene scene({{surface, moved({-1.5, 0, 0}), 1}, {surface, moved({1.5, 0, 0}), 2}});
    const LineSet steep = line_set_with("crease", {120, 1}), flat = line_set_with("crease", {30, 1});
    const auto angles = [](double first, double second) {
        return OwnLines{.parameters = {{definition_index("crease"), 0, {first, second}}}};
    };
    EXPECT_EQ(counts(extract(scene, {flat}, angles(100, as_the_set_says))), (Counts{{{1, 0}, 12}}));
    EXPECT_EQ(counts(extract(scene, {steep}, angles(as_the_set_says, 80))), (Counts{{{1, 0}, 12}}));
    EXPECT_EQ(counts(extract(scene, {steep, flat}, angles(100, 80))), (Counts{{{1, 0}, 12}})) << "in all sets";
    EXPECT_THROW(extract(scene, {flat}, OwnLines{.parameters = {{definition_index("crease"), 0, {1.0}}}}),
                 std::invalid_argument);
}

TEST(OwnLines, MaterialsWithoutLinesHaveThemInNoSet) {
    const Scene scene({place(capped_box())});
    const OwnLines no_sides{.materials = {{0}, {{0, 1}}}}, nothing{.materials = {{0}, {{0, 0}}}};
    const LineSet creases = line_set({"crease"}), top = of_material(creases, {0, 1});
    EXPECT_EQ(counts(extract(scene, {creases}, no_sides)), (Counts{{{0, 0}, 4}}));
    EXPECT_EQ(counts(extract(scene, {top, creases}, no_sides)), (Counts{{{0, 0}, 4}}));
    EXPECT_TRUE(counts(extract(scene, {of_material(creases, {1, 0})}, no_sides)).empty())
        << "its materials have no lines, whatever lies beside them";
    EXPECT_TRUE(counts(extract(scene, {creases}, nothing)).empty());
    EXPECT_THROW(extract(scene, {creases}, OwnLines{.materials = {{1}, {{0}}}}), std::invalid_argument);
}

TEST(Filters, TheResultDoesNotDependOnTheThreads) {
    const auto paths = [](int threads) {
        const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
        const auto surface = two_halves(48).surface();
        const Scene scene({{surface, moved({-1, 0, 0}), 1}, {surface, moved({0.5, 0.3, 0}), 2}});
        const LineSet every = line_set({"smooth_contour", "contour", "crease", "suggestive_contour", "intersection"});
        const OwnLines own{.kinds = {~Kinds(0), ~bit_of("crease")}};
        return extract(scene, {of_material(every, {0, 1}, 2), every}, own);
    };
    const Paths one = paths(1), two = paths(2);
    ASSERT_EQ(one.id, two.id);
    EXPECT_EQ(one.line_set, two.line_set);
    ASSERT_EQ(one.points_obj.size(), two.points_obj.size());
    EXPECT_EQ(std::memcmp(one.points_obj.data(), two.points_obj.data(), one.points_obj.size() * sizeof(vec3)), 0);
}
