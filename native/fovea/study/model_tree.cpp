// SPDX-License-Identifier: GPL-3.0-or-later
#include <fovea/study/model_tree.h>

#include <algorithm>
#include <cmath>

#include <fovea/base/parallel.h>
#include <fovea/study/least_squares.h>

namespace fovea::study {
namespace {

constexpr std::size_t terms = 1 + property_count;
constexpr double node_ridge = 1e-4;
constexpr double drawn = 15.0;  // samples that the sum of the node above counts as, beside those of a node

using Sum = std::array<double, terms>;  // number, and slopes

/// What is known of a node.
struct Known {
    Sum sum{};
    double error = 0.0;  // mean absolute one, as it is for samples to come
    double count = 0.0, weight = 0.0;
    Index above = none;
    bool leaf = false;
};

Sum terms_of(const PropertyRange& range, const PropertyRow& row) {
    Sum found{1.0};
    for (std::size_t i = 0; i < property_count; ++i) found[1 + i] = range.scaled(row, i);
    return found;
}

double value_of(const Sum& sum, const Sum& found) {
    double value = 0.0;
    for (std::size_t i = 0; i < terms; ++i) value += sum[i] * found[i];
    return value;
}

/// By how much errors are larger for samples that were not fitted.
double to_come(double count, double parameters) {
    return count > parameters ? (count + parameters) / (count - parameters) : INFINITY;
}

Known known_of(const Samples& samples, In<Index> order, const PropertyRange& range) {
    LeastSquares equations(terms);
    Known found;
    Sum mean{};
    for (const Index i : order) {
        const double weight = samples.weight[i];
        equations.add(terms_of(range, samples.rows[i]).data(), samples.target[i], weight);
        mean[0] += weight * double(samples.target[i]);
        found.weight += weight;
    }
    mean[0] /= found.weight;
    found.count = double(order.size());
    std::ranges::copy(equations.solved(node_ridge), found.sum.begin());
    double error = 0.0, of_mean = 0.0;
    for (const Index i : order) {
        const double weight = samples.weight[i] / found.weight, target = samples.target[i];
        error += weight * std::abs(value_of(found.sum, terms_of(range, samples.rows[i])) - target);
        of_mean += weight * std::abs(mean[0] - target);
    }
    found.error = error * to_come(found.count, double(terms));
    of_mean *= to_come(found.count, 1.0);
    if (of_mean <= found.error) found.sum = mean, found.error = of_mean;
    return found;
}

/// A leaf's sum, drawn to those above it.
Sum smoothed(const std::vector<Known>& known, Index leaf) {
    Sum sum = known[leaf].sum;
    for (Index at = leaf; known[at].above != none; at = known[at].above)
        for (std::size_t i = 0; i < terms; ++i)
            sum[i] = (known[at].count * sum[i] + drawn * known[known[at].above].sum[i]) / (known[at].count + drawn);
    return sum;
}

/// Numbers of a tree's nodes that are left, those of each level after those of the one above it.
std::vector<Index> left_of(const RegressionTree& tree, const std::vector<Known>& known) {
    std::vector<Index> left{0};
    for (std::size_t next = 0; next < left.size(); ++next) {
        const Index at = left[next];
        if (known[at].leaf) continue;
        for (const Index side : {0u, 1u}) left.push_back(tree.nodes[at].child + side);
    }
    return left;
}

}  // namespace

RegressionTree with_slopes(const RegressionTree& tree, const Samples& samples, In<Index> order,
                           const std::vector<Part>& parts) {
    RegressionTree made;
    made.range = range_of(samples);
    std::vector<Known> known(tree.nodes.size());
    parallel_for(known.size(), 1, [&](std::size_t i) {
        known[i] = known_of(samples, order.subspan(parts[i].begin, parts[i].end - parts[i].begin), made.range);
    });
    for (std::size_t i = known.size(); i-- > 0;) {
        const RegressionTree::Node& node = tree.nodes[i];
        known[i].leaf = node.property < 0;
        if (known[i].leaf) continue;
        const Known &a = known[node.child], &b = known[node.child + 1];
        const double below = (a.weight * a.error + b.weight * b.error) / (a.weight + b.weight);
        known[i].leaf = known[i].error <= below;
        known[i].error = std::min(known[i].error, below);
        known[node.child].above = known[node.child + 1].above = Index(i);
    }
    Index child = 1;
    for (const Index at : left_of(tree, known)) {
        RegressionTree::Node node = tree.nodes[at];
        Sum sum{};
        if (known[at].leaf)
            sum = smoothed(known, at), node = {-1, 0, sum[0]};
        else
            node.child = child, child += 2;
        made.nodes.push_back(node);
        std::copy(sum.begin() + 1, sum.end(), made.slopes.emplace_back().begin());
    }
    return made;
}

}  // namespace fovea::study
