// SPDX-License-Identifier: GPL-3.0-or-later
// Polygons, filled along parallel lines.
#pragma once

#include <functional>

#include <fovea/base/parallel.h>
#include <fovea/base/types.h>

namespace fovea::image {

/// Horizontal lines at y = first + step * i, for 0 <= i < count.
struct ScanLines {
    double first, step;
    int count;

    double y(int i) const { return first + step * i; }
};

/// Lines of a block.
inline constexpr int spans_block = 64;

/// A side of a polygon, from one corner to the next.
struct Side {
    dvec2 from, to;
};

/// Calls visit(line, begin, end) for each interval of x in which a line is inside of the polygons that the sides form,
/// that is, winding is not zero; ascending on each line. Blocks of spans_block lines run in parallel. Polygons may
/// cross and overlap.
void each_span(In<Side> sides, const ScanLines& lines, const std::function<void(int, double, double)>& visit);

}  // namespace fovea::image
