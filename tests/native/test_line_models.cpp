// SPDX-License-Identifier: GPL-3.0-or-later
// Models of lines: synthetic artists are recovered, and files are restored or refused.
#include <gtest/gtest.h>
#include <random>

#include <fovea/study/learn.h>

#include "refused.h"

namespace fovea {
namespace {

using namespace study;
using Kind = LineModel::Kind;

/// Samples of an artist, who draws as likely as target(row) says.
struct Drawn {
    std::vector<PropertyRow> rows;
    std::vector<float> target, weight;

    operator Samples() const { return {rows, target, weight}; }
};

/// Properties at random and without relation to each other: each a whole number of sixteenths from -1 to 1.
template <typename Target>
Drawn drawn(std::size_t count, const Target& target, unsigned seed = 1) {
    std::mt19937 random(seed);
    Drawn made;
    for (std::size_t i = 0; i < count; ++i) {
        PropertyRow row;
        for (float& value : row) value = (float(random() % 33) - 16.0f) / 16.0f;
        made.rows.push_back(row);
        made.target.push_back(float(target(row)));
        made.weight.push_back(1.0f);
    }
    return made;
}

std::size_t most(const std::array<double, property_count>& shares) {
    return std::size_t(std::max_element(shares.begin(), shares.end()) - shares.begin());
}

const auto linear = [](const PropertyRow& row) {
    return 0.5 + 0.2 * row[2] - 0.1 * row[11] + 0.1 * row[5] * row[5] - 0.05 * row[4] * row[13];
};
const auto of_two = [](const PropertyRow& row) { return row[3] > 0.2f && row[9] < -0.1f ? 1.0 : 0.0; };

}  // namespace

TEST(LineModel, RegressionRecoversWeightedSumsOfPropertiesTheirSquaresAndTheirProducts) {
    const LineModel model = learned_regression(drawn(20000, linear));
    for (const PropertyRow& row : drawn(1000, linear, 2).rows) EXPECT_NEAR(model.probability(row), linear(row), 1e-6);
}

TEST(LineModel, RegressionOfPropertiesThatAreEqualOrConstantIsFinite) {
    Drawn samples = drawn(5000, linear);
    for (PropertyRow& row : samples.rows) row[1] = row[2], row[0] = 3.0f;
    const LineModel model = learned_regression(samples);
    EXPECT_LT(squared_error(model, samples), 1e-12);
}

TEST(LineModel, ATreeFindsTheThresholdsOfAnArtistAndNothingElse) {
    const Drawn artist = drawn(20000, of_two);
    const LineModel model = learned_tree(artist);
    ASSERT_EQ(model.trees.size(), 1u);
    std::map<int, double> thresholds;
    for (const auto& node : model.trees[0].nodes)
        if (node.property >= 0) thresholds[node.property] = node.number;
    ASSERT_EQ(thresholds.size(), 2u);
    EXPECT_NEAR(thresholds[3], 0.2, 1.0 / 16.0);
    EXPECT_NEAR(thresholds[9], -0.1, 1.0 / 16.0);
    EXPECT_EQ(model.trees[0].nodes.size(), 5u);
    EXPECT_LT(squared_error(model, drawn(2000, of_two, 3)), 1e-5)
        << "numbers of leaves are drawn to each other a little";
    const LineModel exact = learned_tree(artist, {.slopes = false});
    EXPECT_EQ(squared_error(exact, drawn(2000, of_two, 3)), 0.0);
    EXPECT_TRUE(exact.trees[0].slopes.empty());
}

TEST(LineModel, AThresholdBetweenIntervalsIsFoundToTheNextSample) {
    Drawn artist = drawn(20000, of_two);
    std::mt19937 random(8);
    std::uniform_real_distribution<float> anywhere;
    for (std::size_t i = 0; i < artist.rows.size(); ++i) {
        artist.rows[i][7] = anywhere(random);
        artist.target[i] = artist.rows[i][7] >= 0.70707f ? 0.75f : 0.25f;
    }
    const LineModel model = learned_tree(artist);
    ASSERT_EQ(model.trees[0].nodes.size(), 3u);
    EXPECT_EQ(model.trees[0].nodes[0].property, 7);
    EXPECT_NEAR(model.trees[0].nodes[0].number, 0.70707, 3e-4);
}

TEST(LineModel, ATreeOfAnArtistWithoutThresholdsIsOneLeafThatRecoversHim) {
    const auto sum = [](const PropertyRow& row) { return 0.5 + 0.2 * row[2] - 0.1 * row[11]; };
    const LineModel model = learned_tree(drawn(20000, sum));
    EXPECT_EQ(model.trees[0].nodes.size(), 1u);
    for (const PropertyRow& row : drawn(500, sum, 2).rows) EXPECT_NEAR(model.probability(row), sum(row), 2e-4);
}

TEST(LineModel, ATreeRecoversAnArtistWithAnotherRuleOnEachSideOfAThreshold) {
    const auto two = [](const PropertyRow& row) {
        return row[8] < 0.3f ? 0.6 + 0.3 * row[1] : 0.3 - 0.2 * row[1] + 0.1 * row[14];
    };
    const Drawn artist = drawn(20000, two), others = drawn(2000, two, 2);
    const LineModel model = learned_tree(artist);
    ASSERT_EQ(model.trees[0].nodes.size(), 3u);
    EXPECT_EQ(model.trees[0].nodes[0].property, 8);
    EXPECT_NEAR(model.trees[0].nodes[0].number, 0.3, 1.0 / 16.0);
    EXPECT_LT(squared_error(model, others), 1e-5);
    EXPECT_GT(squared_error(learned_tree(artist, {.slopes = false}), others), 1e-4);
    EXPECT_GT(squared_error(learned_regression(artist), others), 1e-3);
}

TEST(LineModel, TheMostImportantPropertyIsThatWhichAnArtistGoesBy) {
    const auto one = [](const PropertyRow& row) { return row[6] > 0.0f ? 0.9 : row[4] > 0.0f ? 0.2 : 0.1; };
    const Drawn artist = drawn(20000, one), others = drawn(5000, one, 2);
    for (const Kind kind : {Kind::regression, Kind::tree, Kind::forest}) {
        const auto shares = importance(learned(kind, artist), others);
        EXPECT_EQ(most(shares), 6u);
        for (std::size_t k = 0; k < property_count; ++k)
            if (k != 6 && k != 4) {
                EXPECT_LT(shares[k], 0.05 * shares[6]) << k;
            }
    }
    // A property that decides, exchanged, leaves twice the variance.
    const auto alone = importance(learned_tree(drawn(20000, [](const PropertyRow& row) { return row[6] > 0.0f; })),
                                  drawn(20000, [](const PropertyRow& row) { return row[6] > 0.0f; }, 2));
    EXPECT_NEAR(alone[6], 2.0, 0.05);
}

TEST(LineModel, AForestOfOneTreeOfAllSamplesIsThatTree) {
    const Drawn artist = drawn(8000, linear);
    const LineModel tree = learned_tree(artist);
    const LineModel forest = learned_forest(artist, {.trees = 1, .random_samples = false, .tree = TreeOptions{}});
    EXPECT_EQ(forest.trees, tree.trees);
}

TEST(LineModel, AForestIsNearerToSmoothArtistsThanATreeAndTheSameEachTime) {
    const Drawn artist = drawn(20000, linear), others = drawn(5000, linear, 2);
    const LineModel forest = learned_forest(artist, {.tree = {.properties = 8}});
    EXPECT_EQ(forest.trees.size(), most_trees);
    EXPECT_EQ(forest, learned_forest(artist, {.tree = {.properties = 8}}));
    EXPECT_LT(squared_error(forest, others), squared_error(learned_tree(artist), others));
    EXPECT_LT(squared_error(forest, others), moments_of(others).variance);
}

TEST(LineModel, SamplesCountAsOftenAsTheyStandForPixels) {
    // Twice as heavy is twice as often.
    Drawn heavy = drawn(6000, linear), often = heavy;
    for (std::size_t i = 0; i < 3000; ++i) {
        heavy.weight[i] = 2.0f;
        often.rows.push_back(often.rows[i]);
        often.target.push_back(often.target[i]);
        often.weight.push_back(1.0f);
    }
    EXPECT_NEAR(moments_of(heavy).mean, moments_of(often).mean, 1e-12);
    EXPECT_NEAR(moments_of(heavy).variance, moments_of(often).variance, 1e-12);
    const LineModel a = learned_regression(heavy), b = learned_regression(often);
    for (const PropertyRow& row : drawn(100, linear, 3).rows) EXPECT_NEAR(a.probability(row), b.probability(row), 1e-6);
}

TEST(LineModel, NothingToLearnIsToldInASentence) {
    const Drawn constant = drawn(500, [](const PropertyRow&) { return 0.5; });
    for (const Kind kind : {Kind::regression, Kind::tree, Kind::forest})
        EXPECT_NE(refused([&] { learned(kind, constant); }).find("the same everywhere"), std::string::npos);
    EXPECT_NE(refused([&] { learned_tree(Drawn()); }).find("nothing to learn from"), std::string::npos);
    Drawn wrong = drawn(500, linear);
    wrong.rows[3][3] = NAN;
    EXPECT_NE(refused([&] { learned_tree(wrong); }).find("finite"), std::string::npos);
    wrong = drawn(500, linear);
    wrong.weight[4] = 0.0f;
    EXPECT_NE(refused([&] { learned_tree(wrong); }).find("positive"), std::string::npos);
}

TEST(LineModel, FilesRestoreModelsExactly) {
    const Drawn artist = drawn(9000, linear);
    for (const Kind kind : {Kind::regression, Kind::tree, Kind::forest}) {
        LineModel model = learned(kind, artist);
        model.threshold = 0.1 + 0.2;
        const std::string text = write_model(model);
        EXPECT_EQ(read_model(text), model);
        EXPECT_EQ(write_model(read_model(text)), text);
        EXPECT_LT(text.size(), 1u << 20);
    }
}

TEST(LineModel, WhatIsNoModelIsRefusedInASentence) {
    const Drawn artist = drawn(9000, of_two);
    const std::string tree = write_model(learned_tree(artist)), sum = write_model(learned_regression(artist));
    const auto changed = [](std::string text, const std::string& from, const std::string& to) {
        EXPECT_NE(text.find(from), std::string::npos) << from;
        return text.replace(text.find(from), from.size(), to);
    };
    const auto told = [](const std::string& text) { return refused([&] { read_model(text); }); };
    const auto expect = [&](const std::string& text, const std::string& words) {
        EXPECT_NE(told(text).find(words), std::string::npos) << told(text) << " / " << words;
        EXPECT_NE(told(text).find("write it anew by `fovea learn`"), std::string::npos);
    };
    EXPECT_EQ(told(tree), "");
    expect("", "not JSON");
    expect("[]", "'line_model' is missing");
    expect("{\"line_model\": NaN}", "not JSON");
    expect(std::string(2 << 20, ' '), "bytes");
    expect(changed(tree, "\"line_model\": 1", "\"line_model\": 2"), "another version");
    expect(changed(tree, "luminance", "brightness"), "other properties");
    expect(changed(tree, "\"kind\": \"tree\"", "\"kind\": \"bush\""), "'kind' is none");
    expect(changed(tree, "\"threshold\": 0.5", "\"threshold\": 1.5"), "'threshold'");
    expect(changed(tree, "\"threshold\": 0.5", "\"threshold\": 1e999"), "not JSON");
    expect(changed(tree, "\"trees\": [", "\"trees\": [{},"), "'trees' has 2");
    expect(changed(tree, "\"child\": [1", "\"child\": [0"), "a child that does not come after it");
    expect(changed(tree, "\"child\": [1", "\"child\": [4"), "a child that does not come after it");
    expect(changed(tree, "\"child\": [1", "\"child\": [1.5"), "not a whole one");
    expect(changed(tree, "\"child\": [1", "\"child\": [1, 1"), "'child' has 6 numbers, and 5 are needed");
    expect(changed(tree, "\"property\": [", "\"property\": [7"), "from -1 to 14");
    expect(changed(tree, "\"slopes\": [", "\"slopes\": [[],"), "'slopes' has 4 lists, and there are 3 leaves");
    expect(changed(tree, "\"slopes\": [[", "\"slopes\": [[1.0,"), "'slopes' has 16 numbers, and 15 are needed");
    expect(changed(tree, "\"slopes\": [", "\"slopes\": 1, \"other\": ["), "'slopes' is missing, or no list");
    expect(changed(sum, "\"weights\": [", "\"weights\": [1.0, "), "'weights' has 137 numbers, and 136 are needed");
    expect(changed(sum, "\"low\": [-1.0", "\"low\": [2.0"), "above that of 'high'");
    expect(changed(sum, "\"low\": [-1.0", "\"low\": [true"), "no number");
    expect(changed(sum, "\"low\": [-1.0", "\"low\": [-1e300"), "too large");
}

}  // namespace fovea
