// SPDX-License-Identifier: GPL-3.0-or-later
#include <fovea/study/learn.h>

#include <algorithm>
#include <numeric>
#include <random>

#include <fovea/base/parallel.h>
#include <fovea/study/least_squares.h>

namespace fovea::study {
namespace {

constexpr double ridge = 1e-10;  // only terms that others give are decided by it

LeastSquares equations_of(const Samples& samples, const Regression& regression) {
    const auto parts =
        parallel_parts<LeastSquares>(samples.size(), 16384, [&](LeastSquares& part, auto begin, auto end) {
            part = LeastSquares(Regression::terms);
            for (std::size_t n = begin; n < end; ++n)
                part.add(regression.terms_of(samples.rows[n]).data(), samples.target[n], samples.weight[n]);
        });
    LeastSquares sum(Regression::terms);
    for (const LeastSquares& part : parts) sum.add(part);
    return sum;
}

Array<Index> all_of(const Samples& samples) {
    Array<Index> numbers(samples.size());
    std::iota(numbers.begin(), numbers.end(), Index(0));
    return numbers;
}

}  // namespace

LineModel learned_regression(const Samples& samples) {
    check_samples(samples);
    LineModel model{.kind = LineModel::Kind::regression};
    model.regression.range = range_of(samples);
    const std::vector<double> weights = equations_of(samples, model.regression).solved(ridge);
    std::ranges::copy(weights, model.regression.weights.begin());
    return model;
}

LineModel learned_tree(const Samples& samples, const TreeOptions& options) {
    check_samples(samples);
    LineModel model{.kind = LineModel::Kind::tree};
    model.trees.push_back(grown(samples, Binned(samples.rows), all_of(samples), options));
    return model;
}

LineModel learned_forest(const Samples& samples, const ForestOptions& options) {
    check_samples(samples);
    LineModel model{.kind = LineModel::Kind::forest};
    model.trees.resize(std::clamp<std::size_t>(options.trees, 1, most_trees));
    const Binned binned(samples.rows);
    parallel_for(model.trees.size(), 1, [&](std::size_t i) {
        TreeOptions of_tree = options.tree;
        of_tree.seed += i;
        Array<Index> numbers = all_of(samples);
        if (options.random_samples) {
            std::mt19937_64 random(of_tree.seed);
            for (Index& number : numbers) number = Index(random() % samples.size());
        }
        model.trees[i] = grown(samples, binned, std::move(numbers), of_tree);
    });
    return model;
}

LineModel learned(LineModel::Kind kind, const Samples& samples) {
    switch (kind) {
        case LineModel::Kind::regression:
            return learned_regression(samples);
        case LineModel::Kind::tree:
            return learned_tree(samples);
        case LineModel::Kind::forest:
            break;
    }
    return learned_forest(samples);
}

}  // namespace fovea::study
