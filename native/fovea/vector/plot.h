// SPDX-License-Identifier: GPL-3.0-or-later
// Drawings as plotters draw them: a layer for each pen, in it lines of one width without opacity, each once, joined
// where they meet, in an order of short ways.
#pragma once

#include <fovea/vector/compose.h>
#include <fovea/vector/join_lines.h>

namespace fovea::vector {

/// Draws each line once, and joins lines where they meet. Lengths are in units of the page; `unit_mm` is one of them.
std::vector<Line> as_plotted(std::vector<Line> lines, double unit_mm);

/// Puts paths of one curve, layer by layer, into an order of short ways, from the upper left corner of the page on.
/// Closed curves begin where that is shortest.
Way put_in_order(Document& document, double unit_mm);

}  // namespace fovea::vector
