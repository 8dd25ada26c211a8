// SPDX-License-Identifier: GPL-3.0-or-later
#include <fovea/study/learn.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <random>

#include <fovea/base/parallel.h>

namespace fovea::study {
namespace {

constexpr std::size_t terms = Regression::terms;
constexpr double ridge = 1e-10;  // of a term's mean square
constexpr double tail = 0.01;    // of samples at either end of a property's range, which are clamped

/// The normal equations: products of terms, and of terms with the target.
struct Equations {
    std::array<std::array<double, terms>, terms> products{};
    std::array<double, terms> right{};

    void add(const Equations& other) {
        for (std::size_t i = 0; i < terms; ++i) {
            right[i] += other.right[i];
            for (std::size_t k = 0; k <= i; ++k) products[i][k] += other.products[i][k];
        }
    }
};

Equations equations_of(const Samples& samples, const Regression& regression) {
    const auto parts = parallel_parts<Equations>(samples.size(), 16384, [&](Equations& part, auto begin, auto end) {
        for (std::size_t n = begin; n < end; ++n) {
            const Regression::Terms found = regression.terms_of(samples.rows[n]);
            for (std::size_t i = 0; i < terms; ++i) {
                const double weighted = double(samples.weight[n]) * found[i];
                part.right[i] += weighted * double(samples.target[n]);
                for (std::size_t k = 0; k <= i; ++k) part.products[i][k] += weighted * found[k];
            }
        }
    });
    Equations sum;
    for (const Equations& part : parts) sum.add(part);
    return sum;
}

/// By Cholesky's decomposition, in place of the lower triangle.
Regression::Terms solved(Equations equations) {
    auto& l = equations.products;
    for (std::size_t i = 0; i < terms; ++i) {
        for (std::size_t k = 0; k <= i; ++k) {
            double left = l[i][k];
            for (std::size_t j = 0; j < k; ++j) left -= l[i][j] * l[k][j];
            l[i][k] = k < i ? left / l[k][k] : std::sqrt(left);
        }
    }
    Regression::Terms x = equations.right;
    for (std::size_t i = 0; i < terms; ++i) {
        for (std::size_t j = 0; j < i; ++j) x[i] -= l[i][j] * x[j];
        x[i] /= l[i][i];
    }
    for (std::size_t i = terms; i-- > 0;) {
        for (std::size_t j = i + 1; j < terms; ++j) x[i] -= l[j][i] * x[j];
        x[i] /= l[i][i];
    }
    return x;
}

void set_range(const Samples& samples, Regression& regression) {
    parallel_for(property_count, 1, [&](std::size_t property) {
        Array<float> sorted(samples.size());
        for (std::size_t i = 0; i < samples.size(); ++i) sorted[i] = samples.rows[i][property];
        std::sort(sorted.begin(), sorted.end());
        const auto end = std::size_t(tail * double(sorted.size()));
        regression.low[property] = sorted[end];
        regression.high[property] = sorted[sorted.size() - 1 - end];
    });
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
    set_range(samples, model.regression);
    Equations equations = equations_of(samples, model.regression);
    const double weight = equations.products[0][0];
    for (std::size_t i = 0; i < terms; ++i) equations.products[i][i] += ridge * weight;
    model.regression.weights = solved(equations);
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
    model.trees.resize(std::min(options.trees, most_trees));
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
