// SPDX-License-Identifier: GPL-3.0-or-later
// Transfer functions as data (focus/transfer.h evaluates them).
#pragma once

#include <vector>

#include <fovea/base/types.h>
#include <fovea/style/field.h>

namespace fovea::style {

/// Transfer function from a value in [0, 1] (focus, distance, place along a stroke) to the mix of an effect: 0 up to
/// `start`, `strength` from `end` on, the curve in between; start > end reverses it.
struct Transfer {
    double start = 0.0, end = 1.0, strength = 1.0;
    std::vector<dvec2> curve;  ///< (x, y) in [0, 1], x ascending; empty: linear

    static constexpr std::size_t most_points = 32;  ///< maximum size of `curve`

    bool operator==(const Transfer&) const = default;

    static constexpr auto fields = each_of(
        Field{"start", &Transfer::start, "Start",
              "Value (focus: 0 in, 1 out of it; along a stroke: 0 its start, 1 its end) at which the effect begins",
              share},
        Field{"end", &Transfer::end, "End", "Value at which the effect is whole; less than the start turns it around",
              share},
        Field{"strength", &Transfer::strength, "Strength",
              "How strong the effect is where it is whole; 0 switches it off", share},
        Field{"curve", &Transfer::curve, "",
              "Up to 32 points [x, y], both 0 to 1, joined smoothly between start and end; none: straight", share});
};

inline Transfer off() { return {0.0, 1.0, 0.0, {}}; }

}  // namespace fovea::style
