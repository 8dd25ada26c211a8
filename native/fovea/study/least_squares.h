// SPDX-License-Identifier: GPL-3.0-or-later
// Weighted sums of a few terms that are nearest to given values.
#pragma once

#include <vector>

#include <fovea/base/namespaces.h>

namespace fovea::study {

/// The normal equations of `terms` terms, of which the first is 1.
class LeastSquares {
   public:
    explicit LeastSquares(std::size_t terms = 0) : terms_(terms), products_(terms * terms, 0.0), right_(terms, 0.0) {}

    /// A value, and the terms whose sum it is to be.
    void add(const double* terms, double value, double weight);
    void add(const LeastSquares& other);
    /// Factors of the terms. `ridge`: by how much of the whole weight factors of all terms but the first are held near
    /// 0.
    std::vector<double> solved(double ridge) const;

   private:
    std::size_t terms_;
    std::vector<double> products_, right_;  // of the first, the lower triangle
};

}  // namespace fovea::study
