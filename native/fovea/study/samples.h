// SPDX-License-Identifier: GPL-3.0-or-later
// Pixels that models of lines learn from, and by which they are judged.
#pragma once

#include <fovea/study/line_model.h>

namespace fovea::study {

/// Borrowed, parallel: properties, how likely a line is there, and for how many pixels it stands.
struct Samples {
    In<PropertyRow> rows;
    In<float> target, weight;

    std::size_t size() const { return rows.size(); }
};

/// Throws std::invalid_argument in a sentence if the arrays differ in length, hold what is not finite, have weights
/// that are not positive, or leave nothing to learn, as the target is the same everywhere.
void check_samples(const Samples& samples);

/// Of each property what all but 1 % of the samples at either end have.
PropertyRange range_of(const Samples& samples);

/// Weighted mean of the target, and its mean squared deviation from that.
struct Moments {
    double weight = 0.0, mean = 0.0, variance = 0.0;
};
Moments moments_of(const Samples& samples);

/// Mean squared error of a model, by weight.
double squared_error(const LineModel& model, const Samples& samples);

/// For each property by how much the squared error grows when its values are exchanged among the samples at random,
/// as a share of the target's variance; not below 0. Breiman, "Random Forests", 2001, section 10, which takes other
/// samples than those that were learned from: so should be these.
std::array<double, property_count> importance(const LineModel& model, const Samples& samples);

}  // namespace fovea::study
