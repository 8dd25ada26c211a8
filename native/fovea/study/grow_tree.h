// SPDX-License-Identifier: GPL-3.0-or-later
// Regression trees: Breiman, Friedman, Olshen & Stone, "Classification and Regression Trees", 1984.
#pragma once

#include <fovea/study/samples.h>

namespace fovea::study {

struct TreeOptions {
    int depth = 8;                            ///< thresholds on the way to a leaf, at most
    std::size_t least = 200;                  ///< samples in a leaf, at least, or a fiftieth of all, if that is less
    double gain = 1e-4;                       ///< share of the variance that a threshold explains, at least
    std::size_t properties = property_count;  ///< tried at each node, at random if these are not all
    bool slopes = true;                       ///< leaves are weighted sums, not numbers
    std::uint64_t seed = 1;
};

/// For each property and sample which of 64 intervals its value is in, that have as many samples each.
class Binned {
   public:
    static constexpr std::size_t bins = 64;

    explicit Binned(In<PropertyRow> rows);
    const std::uint8_t* of(std::size_t property) const { return codes_[property].data(); }
    /// Whether an interval has one value alone, as of surfaces that are flat.
    bool is_one_value(std::size_t property, std::size_t bin) const { return one_value_[property][bin]; }

   private:
    std::array<Array<std::uint8_t>, property_count> codes_;
    std::array<std::array<bool, bins>, property_count> one_value_{};
};

/// A tree of the samples with these numbers, each as often as it is there. A node's threshold is that which leaves the
/// least squared error, among those between intervals, and then exactly, among those between samples beside it.
///
/// With slopes, a node whose weighted sum alone leaves no more error than its thresholds, as Quinlan's M5 estimates it
/// of samples to come, becomes a leaf; and sums of leaves are drawn to those on the way to them: Quinlan, "Learning
/// with Continuous Classes", 1992; Wang & Witten, "Inducing Model Trees for Continuous Classes", 1997.
RegressionTree grown(const Samples& samples, const Binned& binned, Array<Index> numbers, const TreeOptions& options);

}  // namespace fovea::study
