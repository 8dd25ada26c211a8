// SPDX-License-Identifier: GPL-3.0-or-later
// Model files: numbers alone, each checked, so that a file of anybody can be read.
#include <algorithm>
#include <cmath>

#include <fovea/base/check.h>
#include <fovea/study/line_model.h>
#include <fovea/style/json_value.h>

namespace fovea::study {
namespace {

using style::JsonValue;
using Type = JsonValue::Type;

constexpr int schema = 1;
const std::string remedy = "; write it anew by `fovea learn`";

JsonValue words() {
    JsonValue list = JsonValue::list();
    for (const PropertyName& each : property_names) list.items.push_back(JsonValue::of(std::string(each.name)));
    return list;
}

template <typename Numbers>
JsonValue numbers(const Numbers& values) {
    JsonValue list = JsonValue::list();
    for (const auto value : values) list.items.push_back(JsonValue::of(double(value)));
    return list;
}

void add(const PropertyRange& range, JsonValue& object) {
    object.add("low", numbers(range.low));
    object.add("high", numbers(range.high));
}

JsonValue told(const RegressionTree& tree) {
    JsonValue property = JsonValue::list(), child = JsonValue::list(), number = JsonValue::list();
    for (const RegressionTree::Node& node : tree.nodes) {
        property.items.push_back(JsonValue::of(node.property));
        child.items.push_back(JsonValue::of(int(node.child)));
        number.items.push_back(JsonValue::of(node.number));
    }
    JsonValue object = JsonValue::object();
    object.add("property", std::move(property));
    object.add("child", std::move(child));
    object.add("number", std::move(number));
    if (tree.slopes.empty()) return object;
    add(tree.range, object);
    JsonValue slopes = JsonValue::list();
    for (std::size_t i = 0; i < tree.nodes.size(); ++i)
        if (tree.nodes[i].property < 0) slopes.items.push_back(numbers(tree.slopes[i]));
    object.add("slopes", std::move(slopes));
    return object;
}

[[noreturn]] void refuse(const std::string& what) { style::refuse("a model of lines: " + what + remedy); }

const JsonValue& member(const JsonValue& of, const char* key, Type type) {
    const JsonValue* found = of.type == Type::object ? of.at(style::Step(key)) : nullptr;
    if (!found || found->type != type)
        refuse(std::string("'") + key + "' is missing, or no " + (type == Type::list ? "list" : "value of its kind"));
    return *found;
}

double number_of(const JsonValue& value, const std::string& key) {
    if (value.type != Type::number && value.type != Type::whole) refuse("'" + key + "' holds what is no number");
    return value.number;
}

/// The numbers of a list, so many, within the range of single precision.
std::vector<double> numbers_in(const JsonValue& list, const std::string& key, std::size_t count) {
    if (list.type != Type::list || list.items.size() != count)
        refuse("'" + key + "' has " + std::to_string(list.items.size()) + " numbers, and " + std::to_string(count) +
               " are needed");
    std::vector<double> found;
    for (const JsonValue& item : list.items) {
        found.push_back(number_of(item, key));
        if (!(std::abs(found.back()) <= 1e30)) refuse("'" + key + "' holds a number that is too large");
    }
    return found;
}
std::vector<double> numbers_of(const JsonValue& of, const char* key, std::size_t count) {
    return numbers_in(member(of, key, Type::list), key, count);
}

PropertyRange read_range(const JsonValue& json) {
    PropertyRange found;
    const auto low = numbers_of(json, "low", property_count), high = numbers_of(json, "high", property_count);
    for (std::size_t i = 0; i < property_count; ++i) {
        if (!(low[i] <= high[i])) refuse("'low' holds a number above that of 'high'");
        found.low[i] = float(low[i]), found.high[i] = float(high[i]);
    }
    return found;
}

/// What is added at leaves, if a file has that.
void read_slopes(const JsonValue& json, RegressionTree& tree) {
    if (!json.at(style::Step("slopes"))) return;
    tree.range = read_range(json);
    const JsonValue& slopes = member(json, "slopes", Type::list);
    const auto leaves = std::ranges::count(tree.nodes, -1, &RegressionTree::Node::property);
    if (slopes.items.size() != std::size_t(leaves))
        refuse("'slopes' has " + std::to_string(slopes.items.size()) + " lists, and there are " +
               std::to_string(leaves) + " leaves");
    tree.slopes.resize(tree.nodes.size());
    std::size_t leaf = 0;
    for (std::size_t i = 0; i < tree.nodes.size(); ++i)
        if (tree.nodes[i].property < 0)
            std::ranges::copy(numbers_in(slopes.items[leaf++], "slopes", property_count), tree.slopes[i].begin());
}

int whole_of(double value, const std::string& key, double least, double most) {
    if (!(value >= least && value <= most) || value != std::floor(value))
        refuse("'" + key + "' holds a number that is not a whole one from " + std::to_string(int(least)) + " to " +
               std::to_string(int(most)));
    return int(value);
}

RegressionTree read_tree(const JsonValue& json) {
    const std::size_t count = member(json, "property", Type::list).items.size();
    if (count == 0 || count > most_nodes)
        refuse("a tree has " + std::to_string(count) + " nodes, and 1 to " + std::to_string(most_nodes) + " can be");
    const auto property = numbers_of(json, "property", count), child = numbers_of(json, "child", count),
               number = numbers_of(json, "number", count);
    RegressionTree tree;
    for (std::size_t i = 0; i < count; ++i) {
        RegressionTree::Node node{whole_of(property[i], "property", -1, double(property_count) - 1), 0, number[i]};
        node.child = Index(whole_of(child[i], "child", 0, double(most_nodes)));
        // Children come later, so that every way ends at a leaf.
        if (node.property >= 0 && !(node.child > i && node.child + 1 < count))
            refuse("node " + std::to_string(i) + " of a tree has a child that does not come after it");
        tree.nodes.push_back(node);
    }
    read_slopes(json, tree);
    return tree;
}

Regression read_regression(const JsonValue& json) {
    Regression found{.range = read_range(json)};
    std::ranges::copy(numbers_of(json, "weights", Regression::terms), found.weights.begin());
    return found;
}

LineModel::Kind kind_of(const std::string& word) {
    int i = 0;
    for (const style::Choice& choice : style::choices_of<LineModel::Kind>) {
        if (word == choice.name) return static_cast<LineModel::Kind>(i);
        ++i;
    }
    refuse("'kind' is none of regression, tree, forest");
}

JsonValue parsed(std::string_view json) {
    if (json.size() > style::largest) refuse("it has more than " + std::to_string(style::largest) + " bytes");
    try {
        return style::parse_json(json);
    } catch (const std::invalid_argument&) {
        refuse("it is not JSON of finite numbers");
    }
}

}  // namespace

std::string write_model(const LineModel& model) {
    JsonValue json = JsonValue::object();
    json.add("line_model", JsonValue::of(schema));
    json.add("kind", JsonValue::of(std::string(style::choices_of<LineModel::Kind>[std::size_t(model.kind)].name)));
    json.add("threshold", JsonValue::of(model.threshold));
    json.add("properties", words());
    if (model.kind == LineModel::Kind::regression) {
        JsonValue regression = JsonValue::object();
        add(model.regression.range, regression);
        regression.add("weights", numbers(model.regression.weights));
        json.add("regression", std::move(regression));
    } else {
        JsonValue trees = JsonValue::list();
        for (const RegressionTree& tree : model.trees) trees.items.push_back(told(tree));
        json.add("trees", std::move(trees));
    }
    return json.written(false) + "\n";
}

LineModel read_model(std::string_view text) {
    const JsonValue json = parsed(text);
    if (number_of(member(json, "line_model", Type::whole), "line_model") != schema)
        refuse("it is of another version of Fovea");
    std::vector<std::string> known, named;
    for (const PropertyName& each : property_names) known.emplace_back(each.name);
    for (const JsonValue& each : member(json, "properties", Type::list).items) named.push_back(each.text);
    if (known != named) refuse("it has learned from other properties than those that Fovea knows");
    LineModel model;
    model.kind = kind_of(member(json, "kind", Type::text).text);
    model.threshold = number_of(member(json, "threshold", Type::number), "threshold");
    if (!(model.threshold >= 0.0 && model.threshold <= 1.0)) refuse("'threshold' is not from 0 to 1");
    if (model.kind == LineModel::Kind::regression) {
        model.regression = read_regression(member(json, "regression", Type::object));
        return model;
    }
    const std::vector<JsonValue>& trees = member(json, "trees", Type::list).items;
    const std::size_t most = model.kind == LineModel::Kind::tree ? 1 : most_trees;
    if (trees.empty() || trees.size() > most)
        refuse("'trees' has " + std::to_string(trees.size()) + ", and 1 to " + std::to_string(most) + " can be");
    for (const JsonValue& tree : trees) model.trees.push_back(read_tree(tree));
    return model;
}

}  // namespace fovea::study
