// SPDX-License-Identifier: GPL-3.0-or-later
// Figures: lines that meet at their ends, like the outlines of letters (runs/groups.h, with whole paths). A small one
// is thinned as a whole: line by line, what is left of it could not be read. One that its pen fills is a dot: a leaf or
// a pebble far away. Crowds of dots are spots of plain ink unless each keeps its distance from all others.
#pragma once

#include <fovea/elision/own_band.h>
#include <fovea/runs/groups.h>

namespace fovea::elision {

/// Size from which a figure is no letter [px of the reference picture].
inline constexpr double largest_figure = 48.0;

/// Fills OwnBands::figure and figure_of_rank. A figure counts as small, with a weight of 1, up to twice the
/// distance that its lines keep from others, and not at all from four times on; nor from `largest_px` on, whatever they
/// keep: where lines shall be few, a box is not a letter.
void mark_figures(const Groups& figures, const Runs& runs, In<Index> ranks, float largest_px, OwnBands& own);

/// Makes dots of figures that are not larger than the pens of their lines are wide; from three times that size on they
/// are none, and in between in part. A dot is thinned as a whole, loses at any angle, and reserves what is nearer to
/// its lines than the width of its pen, beyond their ends, too. `pen_px`: per run, the width of its pen [px].
void mark_dots(const Groups& figures, In<float> pen_px, OwnBands& own);

}  // namespace fovea::elision
