// SPDX-License-Identifier: GPL-3.0-or-later
#include <fovea/study/least_squares.h>

#include <cmath>

namespace fovea::study {

void LeastSquares::add(const double* terms, double value, double weight) {
    for (std::size_t i = 0; i < terms_; ++i) {
        const double weighted = weight * terms[i];
        double* const row = &products_[i * terms_];
        right_[i] += weighted * value;
        for (std::size_t k = 0; k <= i; ++k) row[k] += weighted * terms[k];
    }
}

void LeastSquares::add(const LeastSquares& other) {
    for (std::size_t i = 0; i < products_.size(); ++i) products_[i] += other.products_[i];
    for (std::size_t i = 0; i < terms_; ++i) right_[i] += other.right_[i];
}

/// By Cholesky's decomposition.
std::vector<double> LeastSquares::solved(double ridge) const {
    std::vector<double> l = products_, x = right_;
    for (std::size_t i = 1; i < terms_; ++i) l[i * terms_ + i] += ridge * products_[0];
    const auto at = [&](std::size_t i, std::size_t k) -> double& { return l[i * terms_ + k]; };
    for (std::size_t i = 0; i < terms_; ++i)
        for (std::size_t k = 0; k <= i; ++k) {
            double left = at(i, k);
            for (std::size_t j = 0; j < k; ++j) left -= at(i, j) * at(k, j);
            at(i, k) = k < i ? left / at(k, k) : std::sqrt(left);
        }
    for (std::size_t i = 0; i < terms_; ++i) {
        for (std::size_t j = 0; j < i; ++j) x[i] -= at(i, j) * x[j];
        x[i] /= at(i, i);
    }
    for (std::size_t i = terms_; i-- > 0;) {
        for (std::size_t j = i + 1; j < terms_; ++j) x[i] -= at(j, i) * x[j];
        x[i] /= at(i, i);
    }
    return x;
}

}  // namespace fovea::study
