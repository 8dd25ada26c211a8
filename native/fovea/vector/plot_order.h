// SPDX-License-Identifier: GPL-3.0-or-later
// The order in which a pen draws strokes with little way between them: from each to the nearest end of another, then
// improved by turning parts of the way around (2-opt) and by moving strokes (or-opt). Croes, "A Method for Solving
// Traveling-Salesman Problems", 1958; Or, 1976.
#pragma once

#include <fovea/base/types.h>

namespace fovea::vector {

/// Where a pen goes down and up again.
struct Stop {
    dvec2 start, end;
};

/// A stroke of a plan, and whether it is drawn from its end to its start.
struct Turn {
    std::size_t stroke;
    bool reversed;
};

/// Places that are tried to shorten the way: seconds.
inline constexpr std::size_t most_trials = 100'000'000;

/// Each stroke once. The pen begins at `home`, and ends anywhere. The same for the same strokes: after so many trials,
/// or about that, it stays as it is. Polls Cancelling.
std::vector<Turn> plot_order(In<Stop> strokes, const dvec2& home, std::size_t trials = most_trials);

/// The same by the nearest end alone.
std::vector<Turn> nearest_order(In<Stop> strokes, const dvec2& home);

/// Length of the way between strokes, from home to the first of them included.
double way_between(In<Stop> strokes, const std::vector<Turn>& plan, const dvec2& home);

}  // namespace fovea::vector
