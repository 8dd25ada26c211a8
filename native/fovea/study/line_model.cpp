// SPDX-License-Identifier: GPL-3.0-or-later
#include <fovea/study/line_model.h>

#include <algorithm>
#include <cmath>

#include <fovea/base/parallel.h>

namespace fovea::study {

double PropertyRange::scaled(const PropertyRow& row, std::size_t property) const {
    const double least = low[property], width = double(high[property]) - least;
    const double inside = double(std::clamp(row[property], low[property], high[property])) - least;
    return width > 0.0 ? 2.0 * inside / width - 1.0 : 0.0;
}

Regression::Terms Regression::terms_of(const PropertyRow& row) const {
    Terms found{};
    found[0] = 1.0;
    for (std::size_t i = 0; i < property_count; ++i) found[1 + i] = range.scaled(row, i);
    std::size_t term = 1 + property_count;
    for (std::size_t i = 1; i <= property_count; ++i)
        for (std::size_t k = i; k <= property_count; ++k) found[term++] = found[i] * found[k];
    return found;
}

double Regression::value(const PropertyRow& row) const {
    const Terms found = terms_of(row);
    double sum = 0.0;
    for (std::size_t i = 0; i < terms; ++i) sum += weights[i] * found[i];
    return sum;
}

double RegressionTree::value(const PropertyRow& row) const {
    const Node* node = nodes.data();
    while (node->property >= 0) {
        const bool above = double(row[std::size_t(node->property)]) >= node->number;
        node = &nodes[node->child + (above ? 1 : 0)];
    }
    double sum = node->number;
    if (!slopes.empty()) {
        const auto& slope = slopes[std::size_t(node - nodes.data())];
        for (std::size_t i = 0; i < property_count; ++i) sum += slope[i] * range.scaled(row, i);
    }
    return sum;
}

double LineModel::probability(const PropertyRow& row) const {
    double value = 0.0;
    if (kind == Kind::regression) {
        value = regression.value(row);
    } else {
        for (const RegressionTree& tree : trees) value += tree.value(row);
        value /= double(trees.size());
    }
    return std::clamp(value, 0.0, 1.0);
}

Array<float> probabilities(const LineModel& model, const LocalProperties& properties) {
    return parallel_map<float>(properties.rows.size(), [&](std::size_t i) {
        return properties.known.set[i] ? float(model.probability(properties.rows[i])) : 0.0f;
    });
}

}  // namespace fovea::study
