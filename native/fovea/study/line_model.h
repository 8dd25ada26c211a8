// SPDX-License-Identifier: GPL-3.0-or-later
// What has been learned of drawings: how likely a line is, by the local properties of a pixel. Cole 2009, sections
// 3.2.4 and 3.2.5.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <fovea/study/local_properties.h>
#include <fovea/style/field.h>

namespace fovea::study {

/// What properties are clamped to, so that no model is asked for what it has not seen.
struct PropertyRange {
    PropertyRow low{}, high{};

    /// A property within this, from -1 to 1; 0 where it has one value.
    double scaled(const PropertyRow& row, std::size_t property) const;
    bool operator==(const PropertyRange&) const = default;
};

/// A weighted sum of properties, their squares and their products.
struct Regression {
    /// One, the properties, and the products of each with itself and those after it.
    static constexpr std::size_t terms = 1 + property_count + property_count * (property_count + 1) / 2;
    using Terms = std::array<double, terms>;

    PropertyRange range{};
    Terms weights{};  ///< of terms of scaled properties

    Terms terms_of(const PropertyRow& row) const;
    double value(const PropertyRow& row) const;
    bool operator==(const Regression&) const = default;
};

/// A binary tree, the root first.
struct RegressionTree {
    struct Node {
        int property = -1;    ///< that decides; -1: a leaf
        Index child = 0;      ///< where the property is below `number`; the other one, where it is not, follows
        double number = 0.0;  ///< of a leaf its value
        bool operator==(const Node&) const = default;
    };
    std::vector<Node> nodes;
    /// Per node, or none: what is added to a leaf's number for each scaled property.
    PropertyRange range{};
    std::vector<std::array<double, property_count>> slopes{};

    double value(const PropertyRow& row) const;
    bool operator==(const RegressionTree&) const = default;
};

/// Trees and forests stay so small that a model is a small file.
inline constexpr std::size_t most_nodes = 511, most_trees = 50;

struct LineModel {
    enum class Kind : std::uint8_t { regression, tree, forest };

    Kind kind = Kind::tree;
    double threshold = 0.5;  ///< probability from which on there are lines
    Regression regression{};
    std::vector<RegressionTree> trees{};  ///< a tree has one; the value of a forest is their mean

    /// In [0, 1].
    double probability(const PropertyRow& row) const;
    bool operator==(const LineModel&) const = default;
};

/// Of each pixel whose properties are known; 0 of others.
Array<float> probabilities(const LineModel& model, const LocalProperties& properties);

/// As a JSON file, and from one. read_model restores the model exactly. Throws std::invalid_argument with a sentence
/// for what is no model: files are data of others.
std::string write_model(const LineModel& model);
LineModel read_model(std::string_view json);

}  // namespace fovea::study

namespace fovea::style {
template <>
inline constexpr Choice choices_of<study::LineModel::Kind>[] = {
    {"regression", "Regression", "A weighted sum of properties, their squares and their products"},
    {"tree", "Tree", "Thresholds of properties, one after the other"},
    {"forest", "Forest", "The mean of many trees, each of random pixels"},
};
}  // namespace fovea::style
