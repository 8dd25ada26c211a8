// SPDX-License-Identifier: GPL-3.0-or-later
#include <fovea/study/samples.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <random>

#include <fovea/base/check.h>
#include <fovea/base/parallel.h>

namespace fovea::study {
namespace {

constexpr std::size_t block = 4096;
constexpr std::uint64_t seed = 1;
constexpr double tail = 0.01;  // of samples, which are clamped

/// Sum of value(i), in an order that does not depend on the number of threads.
template <typename Value>
double sum_of(std::size_t count, const Value& value) {
    const auto parts = parallel_parts<double>(count, block, [&](double& part, std::size_t begin, std::size_t end) {
        part = 0.0;
        for (std::size_t i = begin; i < end; ++i) part += value(i);
    });
    return std::accumulate(parts.begin(), parts.end(), 0.0);
}

double squared(double value) { return value * value; }

}  // namespace

void check_samples(const Samples& samples) {
    check(samples.target.size() == samples.size() && samples.weight.size() == samples.size(),
          "samples need a target and a weight each");
    check(samples.size() > 0, "there is nothing to learn from: no surface is seen where lines are drawn");
    for (std::size_t i = 0; i < samples.size(); ++i) {
        const PropertyRow& row = samples.rows[i];
        check(std::ranges::all_of(row, [](float value) { return std::isfinite(value); }) &&
                  std::isfinite(samples.target[i]),
              "samples hold what is no finite number");
        check(samples.weight[i] > 0.0f && std::isfinite(samples.weight[i]), "weights of samples have to be positive");
    }
    const auto [least, most] = std::ranges::minmax(samples.target);
    check(least < most,
          "the drawings are the same everywhere on the surfaces: there is nothing to learn from them; "
          "look whether they show this scene");
}

PropertyRange range_of(const Samples& samples) {
    PropertyRange found;
    parallel_for(property_count, 1, [&](std::size_t property) {
        Array<float> sorted(samples.size());
        for (std::size_t i = 0; i < samples.size(); ++i) sorted[i] = samples.rows[i][property];
        std::sort(sorted.begin(), sorted.end());
        const auto end = std::size_t(tail * double(sorted.size()));
        found.low[property] = sorted[end];
        found.high[property] = sorted[sorted.size() - 1 - end];
    });
    return found;
}

Moments moments_of(const Samples& samples) {
    Moments found;
    found.weight = sum_of(samples.size(), [&](std::size_t i) { return double(samples.weight[i]); });
    found.mean = sum_of(samples.size(), [&](std::size_t i) { return double(samples.weight[i]) * samples.target[i]; }) /
                 found.weight;
    found.variance =
        sum_of(samples.size(),
               [&](std::size_t i) { return double(samples.weight[i]) * squared(samples.target[i] - found.mean); }) /
        found.weight;
    return found;
}

double squared_error(const LineModel& model, const Samples& samples) {
    const double weight = sum_of(samples.size(), [&](std::size_t i) { return double(samples.weight[i]); });
    return sum_of(samples.size(),
                  [&](std::size_t i) {
                      return double(samples.weight[i]) *
                             squared(model.probability(samples.rows[i]) - samples.target[i]);
                  }) /
           weight;
}

std::array<double, property_count> importance(const LineModel& model, const Samples& samples) {
    check_samples(samples);
    const double usual = squared_error(model, samples), variance = moments_of(samples).variance;
    std::array<double, property_count> found{};
    Array<PropertyRow> rows(samples.rows.begin(), samples.rows.end());
    for (std::size_t property = 0; property < property_count; ++property) {
        std::mt19937_64 random(seed);
        for (std::size_t i = rows.size() - 1; i > 0; --i)
            std::swap(rows[i][property], rows[std::size_t(random() % (i + 1))][property]);
        const double other = squared_error(model, {rows, samples.target, samples.weight});
        found[property] = std::max(0.0, (other - usual) / variance);
        for (std::size_t i = 0; i < rows.size(); ++i) rows[i][property] = samples.rows[i][property];
    }
    return found;
}

}  // namespace fovea::study
