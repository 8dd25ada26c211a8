// SPDX-License-Identifier: GPL-3.0-or-later
// Lines by a model of where an artist draws: where it says, to fractions of a pixel, and in every picture the same.
#include <gtest/gtest.h>

#include <fovea/line/likelihood.h>

#include "drawing.h"
#include "learned.h"

using namespace fovea;
using namespace fovea::draw;
using namespace fovea::meshes;
using namespace fovea::drawing;

namespace {

/// 80 pixels a unit.
const View from_front = orthographic({0, -10, 0}, {0, 0, 0}, 8);

LineSet with(std::shared_ptr<const FileContent> file, double threshold = 1.0) {
    LineSet set = line_set({"learned_line"});
    set.kinds[0].values[0] = threshold;
    set.kinds[0].values.file = std::move(file);
    return set;
}

LineSet by(const study::LineModel& model) { return with(study::likelihood_of(model)); }

/// As likely as a Gaussian of the distance to a vertical line says, so many pixels wide.
struct Crest : line::Likelihood {
    double x, width, most;

    Crest(double at, double wide, double height) : x(at), width(wide), most(height) {}
    double threshold() const override { return 0.5; }
    image::Buffer at(const Tracer&, const image::ShadedBuffer& shaded, const Cancel&) const override {
        image::Buffer found(shaded.lattice.size());
        for (int j = 0; j < shaded.lattice.height; ++j)
            for (int i = 0; i < shaded.lattice.width; ++i) {
                const double away = (shaded.lattice.px(dvec2(i, j)).x - x) / width;
                found[shaded.lattice.at(i, j)] = float(most * std::exp(-0.5 * away * away));
            }
        return found;
    }
};

/// A file of some other kind.
struct Other : FileContent {};

std::vector<Placement> plate() { return {place(box(), scaled({2, 1, 2}))}; }

std::vector<Placement> things() { return {place(box()), place(sphere(48), moved({1, -1.5, 0.3}), 2)}; }

const study::LineModel of_facing = lines_below(study::Property::facing, 0.3);

}  // namespace

TEST(LearnedLine, LiesOnTheCrestOfTheLikelihood) {
    for (const double x : {300.3, 341.77}) {
        const Drawing drawing(plate(), from_front, {with(std::make_shared<Crest>(x, 3.0, 1.0))});
        ASSERT_EQ(drawing.paths.count(), 1u);
        for (const vec2& px : drawing.clipped.px) EXPECT_NEAR(px.x, x, 0.01);
        EXPECT_EQ(*std::ranges::max_element(drawing.paths.strength), 1.0f);
    }
}

TEST(LearnedLine, BeginsAtTheThresholdOfItsModelAsOftenAsTheStyleHasIt) {
    // Smoothed by 2.5 reference pixels, the Gaussian is lower, as its area stays.
    const double sigma = 2.5 * from_front.reference_scale, least = 0.5 * std::sqrt(1.0 + sigma * sigma / 9.0);
    for (const double times : {0.8, 1.0, 1.5})
        for (const double more : {0.97, 1.03}) {
            const auto crest = std::make_shared<Crest>(300.3, 3.0, more * times * least);
            const Drawing drawing(plate(), from_front, {with(crest, times)});
            EXPECT_EQ(drawing.paths.count(), more > 1.0 ? 1u : 0u) << times << " " << more;
        }
}

TEST(LearnedLine, IsWhereTheRuleOfTheModelHolds) {
    // Of a sphere, a ring inside of its outline, and beside it as far as that may lie.
    const Drawing drawing({place(sphere(96))}, from_front, {by(of_facing)});
    ASSERT_GT(drawing.paths.count(), 0u);
    const double inner = 80.0 * std::sqrt(1.0 - 0.3 * 0.3), outer = 80.0 + 4.0 * glm::length(dvec2(640, 480)) / 1280.0;
    double turned = 0.0;
    for (const vec2& px : drawing.clipped.px) {
        const double away = glm::distance(dvec2(px), dvec2(320, 240));
        EXPECT_GT(away, inner);
        EXPECT_LT(away, outer);
        turned += away;
    }
    EXPECT_NEAR(turned / double(drawing.clipped.px.size()), 0.5 * (inner + outer), 0.7);
    EXPECT_GT(drawing.visible_px(none), 2 * 3.0 * 80.0);
}

TEST(LearnedLine, WithoutAModelThereIsNoneAndOthersAreAsTheyAre) {
    for (const auto& file : {std::shared_ptr<const FileContent>(), std::shared_ptr<const FileContent>(new Other)})
        EXPECT_EQ(Drawing(things(), from_front, {with(file)}).paths.count(), 0u);
    const LineSet others = line_set({"image_edge", "crease"});
    LineSet all = others;
    all.kinds.push_back(by(of_facing).kinds[0]);
    const Drawing plain(things(), from_front, {others}), both(things(), from_front, {all});
    EXPECT_GT(both.paths.count(), plain.paths.count());
    for (Index p = 0; p < plain.paths.count(); ++p)
        EXPECT_NE(std::ranges::find(both.paths.id, plain.paths.id[p]), both.paths.id.end());
}

TEST(LearnedLine, IsTheSameAtEverySizeOfThePicture) {
    View full = perspective({3, -5, 2}, {0, 0, 0}), half = full;
    half.width /= 2;
    half.height /= 2;
    half.reference_scale = 0.5;
    const Drawing large(things(), full, {by(of_facing)}), small(things(), half, {by(of_facing)});
    ASSERT_GT(large.paths.count(), 0u);
    ASSERT_EQ(large.paths.points_obj.size(), small.paths.points_obj.size());
    for (std::size_t i = 0; i < large.paths.points_obj.size(); ++i)
        EXPECT_LT(glm::distance(large.paths.points_obj[i], small.paths.points_obj[i]), 1e-4f);
}

TEST(LearnedLine, PropertiesOfPixelsAreThoseOfALatticeOfPixels) {
    const Scene scene(things());
    const Tracer tracer(scene, from_front);
    const study::LocalProperties pixels = study::local_properties(tracer, Cancel());
    // A wider border has the same pixels in its middle.
    constexpr int more = 20;
    const image::Lattice lattice{dvec2(0.5 - more), 1.0, from_front.width + 2 * more, from_front.height + 2 * more};
    const study::LocalProperties nodes =
        study::local_properties(tracer, image::shade(tracer, lattice, {}, Cancel()), more, Cancel());
    EXPECT_EQ(pixels.known.set, nodes.known.set);
    EXPECT_EQ(pixels.rows, nodes.rows);
}

TEST(Registry, OnlyDefinitionsThatDependOnTheSceneAreGivenFiles) {
    int given = 0;
    for (const LineDefinition* definition : line_definitions())
        if (definition->file) {
            EXPECT_EQ(definition->scope, Scope::scene) << definition->name;
            for (const Parameter& parameter : definition->parameters)
                EXPECT_STRNE(parameter.name, definition->file->name) << definition->name;
            ++given;
        }
    EXPECT_GT(given, 0);
}
