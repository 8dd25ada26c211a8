// SPDX-License-Identifier: GPL-3.0-or-later
// Trees whose leaves are weighted sums of properties: M5. Quinlan, "Learning with Continuous Classes", 1992; Wang &
// Witten, "Inducing Model Trees for Continuous Classes", 1997.
#pragma once

#include <fovea/study/samples.h>

namespace fovea::study {

/// The samples of a node: a range of an order of their numbers.
struct Part {
    std::size_t begin, end;
};

/// The tree with slopes. `parts`: per node. A node whose sum alone has no more error than what is below it, with errors
/// estimated for samples to come, becomes a leaf; a sum that is no better than its mean is a number; and those of
/// leaves are drawn to those of the nodes above them.
RegressionTree with_slopes(const RegressionTree& tree, const Samples& samples, In<Index> order,
                           const std::vector<Part>& parts);

}  // namespace fovea::study
