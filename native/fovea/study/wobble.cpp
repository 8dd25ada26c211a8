// SPDX-License-Identifier: GPL-3.0-or-later
#include <fovea/study/wobble.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include <fovea/base/check.h>
#include <fovea/base/parallel.h>
#include <fovea/stroke/noise.h>

namespace fovea::study {
namespace {

constexpr double shortest = 8.0, finer = 1.08;  // [px] of waves that can be told, and the factor between them
constexpr std::int64_t nearest = 3;             // [px] between samples whose noise is their own
constexpr double farther = 1.3;                 // factor between distances
constexpr std::size_t least_pairs = 300;        // at a distance
constexpr std::size_t least_distances = 4;
constexpr float jump = 2.5f;                             // [px] between neighbors, which are of two strokes
constexpr double least_amount = 0.5;                     // [px]
constexpr double least_rest = 0.01, least_better = 0.5;  // of what turned lines do not explain, and a share of it
constexpr int table_size = 256, quadrature = 400;

/// Mean products of stroke::two_octaves and itself, by their distance in waves; between as many points per wave as
/// stroke::wobble moves it is linear.
class Products {
   public:
    Products() {
        for (int i = 0; i <= table_size; ++i) {
            double sum = 0.0;
            for (int k = 0; k < quadrature; ++k) {
                const double u = -1.0 + 2.0 * (k + 0.5) / quadrature;
                sum += share(u) * share(u + 2.0 * i / table_size);
            }
            table_[std::size_t(i)] = sum * 2.0 / quadrature / 3.0;
        }
    }
    double at(double waves) const {
        const double steps = waves * stroke::steps_per_wave, below = std::floor(steps);
        double sum = 0.0;
        for (int k = -1; k <= 2; ++k)
            sum += between(below + k - steps) * of_both(std::abs(below + k) / stroke::steps_per_wave);
        return sum;
    }

   private:
    /// Of a number at an integer in the noise at a distance from it.
    static double share(double distance) { return 1.0 - stroke::eased(std::min(std::abs(distance), 1.0)); }
    /// Product of two linear interpolations: the cubic B-spline.
    static double between(double steps) {
        const double t = std::abs(steps);
        if (t >= 2.0) return 0.0;
        return t < 1.0 ? (4.0 - 6.0 * t * t + 3.0 * t * t * t) / 6.0 : (2.0 - t) * (2.0 - t) * (2.0 - t) / 6.0;
    }
    double of_both(double waves) const { return (4.0 * of_one(waves) + of_one(2.0 * waves)) / 9.0; }
    double of_one(double distance) const {
        const double at = std::min(distance / 2.0, 1.0) * table_size;
        const auto i = std::size_t(std::min(at, table_size - 1.0));
        return std::lerp(table_[i], table_[i + 1], at - double(i));
    }
    std::array<double, table_size + 1> table_{};
};

struct Distances {
    std::vector<std::int64_t> px;
    std::vector<double> squares;  // mean squared differences there
};

/// Calls visit(line length, k) for all pairs of samples k, k + distance of one stroke.
template <typename Visit>
void for_each_pair(In<float> away, In<std::int64_t> first, std::int64_t distance, const Visit& visit) {
    for (std::size_t i = 0; i + 1 < first.size(); ++i) {
        std::int64_t of_stroke = 0;  // samples of one stroke up to here
        for (std::int64_t k = first[i]; k < first[i + 1]; ++k) {
            const float here = away[std::size_t(k)], before = k > first[i] ? away[std::size_t(k - 1)] : NAN;
            of_stroke = std::isnan(here) ? 0 : std::abs(here - before) <= jump ? of_stroke + 1 : 1;
            if (of_stroke > distance) visit(first[i + 1] - first[i], k - distance - first[i], k);
        }
    }
}

Distances distances_of(In<float> away, In<std::int64_t> first, double longest) {
    Distances found;
    for (double exact = nearest; exact <= longest; exact *= farther) {
        const auto px = std::int64_t(std::lround(exact));
        if (!found.px.empty() && px == found.px.back()) continue;
        double sum = 0.0;
        std::size_t pairs = 0;
        for_each_pair(away, first, px, [&](std::int64_t, std::int64_t, std::int64_t k) {
            const double apart = double(away[std::size_t(k)]) - double(away[std::size_t(k - px)]);
            sum += apart * apart, ++pairs;
        });
        if (pairs < least_pairs) break;
        found.px.push_back(px), found.squares.push_back(sum / double(pairs));
    }
    return found;
}

struct Fit {
    double amount2 = 0.0, rest = INFINITY;
};

/// By least squares of shares of `squares`: of `shape`, squares of a movement of one pixel, and of noise, which has the
/// same at all distances; neither below zero. `rest`: the mean squared share that is not explained.
Fit fit_of(const std::vector<double>& squares, const std::vector<double>& shape) {
    double ss = 0.0, s1 = 0.0, n1 = 0.0, sy = 0.0, y1 = 0.0;
    for (std::size_t h = 0; h < squares.size(); ++h) {
        const double s = shape[h] / squares[h], one = 1.0 / squares[h];
        ss += s * s, s1 += s * one, n1 += one * one, sy += s, y1 += one;
    }
    const double determinant = ss * n1 - s1 * s1;
    double amount2 = determinant > 0.0 ? (sy * n1 - y1 * s1) / determinant : 0.0;
    double noise = determinant > 0.0 ? (y1 * ss - sy * s1) / determinant : y1 / n1;
    if (noise < 0.0) noise = 0.0, amount2 = sy / ss;
    if (amount2 < 0.0) amount2 = 0.0, noise = y1 / n1;
    Fit fit{amount2, 0.0};
    for (std::size_t h = 0; h < squares.size(); ++h) {
        const double off = (amount2 * shape[h] + noise) / squares[h] - 1.0;
        fit.rest += off * off / double(squares.size());
    }
    return fit;
}

/// Of lines that are turned, and noise: their squares grow with those of distances.
Fit fit_of_turned(const Distances& found) {
    std::vector<double> shape;
    for (const std::int64_t px : found.px) shape.push_back(double(px * px));
    return fit_of(found.squares, shape);
}

}  // namespace

Wobble fitted_wobble(In<float> away, In<std::int64_t> first, double longest) {
    check(!first.empty() && std::size_t(first.back()) == away.size(), "first: as of StrokeCourses");
    const Products products;
    const Distances found = distances_of(away, first, longest);
    Wobble wobble;
    wobble.samples = std::size_t(std::ranges::count_if(away, [](float value) { return !std::isnan(value); }));
    if (found.px.size() < least_distances) return wobble;
    std::vector<double> lengths;
    for (double length = shortest; length <= longest; length *= finer) lengths.push_back(length);
    std::vector<Fit> fits(lengths.size());
    parallel_for(lengths.size(), 1, [&](std::size_t i) {
        std::vector<double> shape;
        for (const std::int64_t px : found.px) {
            const double same = products.at(0.0), at = products.at(double(px) / lengths[i]);
            double sum = 0.0;
            std::size_t pairs = 0;
            for_each_pair(away, first, px, [&](std::int64_t line, std::int64_t k, std::int64_t) {
                const auto inside = [&](std::int64_t sample) {
                    const double s = double(sample) + 0.5;
                    return std::clamp(std::min(s, double(line) - s) / lengths[i], 0.0, 1.0);
                };
                const double a = inside(k), b = inside(k + px);
                sum += same * (a * a + b * b) - 2.0 * at * a * b, ++pairs;
            });
            shape.push_back(sum / double(pairs));
        }
        fits[i] = fit_of(found.squares, shape);
    });
    const auto best =
        std::size_t(std::ranges::min_element(fits, {}, [](const Fit& fit) { return fit.rest; }) - fits.begin());
    const double other = fit_of_turned(found).rest;
    const double amount = std::sqrt(fits[best].amount2);
    const bool is_better = other > least_rest && fits[best].rest < least_better * other;
    if (amount < least_amount || !is_better) return wobble;
    wobble.amount = amount, wobble.length = lengths[best];
    return wobble;
}

}  // namespace fovea::study
