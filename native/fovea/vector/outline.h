// SPDX-License-Identifier: GPL-3.0-or-later
// Outlines of strokes whose width changes.
#pragma once

#include <fovea/vector/curve.h>

namespace fovea::vector {

/// Which ends of a line are half discs; the others are cut off straight.
struct RoundEnds {
    bool start, end;
};

/// Curves around a polyline of at least two points with a width at each, to be filled by the nonzero rule: one, or for
/// a closed polyline, whose last point repeats the first, one on each side. Bends are mitred and rounded as those
/// of strokes (stroke/strip.h). Each side keeps within `tolerance`, as in `fit`.
std::vector<Curve> outline(In<dvec2> points, In<double> widths, bool closed, RoundEnds round, double tolerance);

}  // namespace fovea::vector
