// SPDX-License-Identifier: GPL-3.0-or-later
// The elision test: how much of a line's own band is lost to lines of higher priority alongside.
#pragma once

#include <fovea/elision/own_band.h>
#include <fovea/elision/priority_buffer.h>

namespace fovea::elision {

/// The window: 5 pixels along the line, in this many columns, each across the whole width of the band.
inline constexpr float window_length_px = 5.0f;
inline constexpr int window_columns = 3;
/// Maximum number of sample positions per column; below it they are at most half a pixel apart.
inline constexpr int most_window_rows = 8;
/// Distance from a run's end, in half widths of its band, beyond which it no longer counts as meeting another line
/// there.
inline constexpr float end_reach = 8.0f;

/// Per sample of a run: pixels of the line's own band in the window (y), and how many of these are lost (x); pixels
/// crossed by the band's edge, or by an end of the run, count in part. (0, 0) outside of the picture. So x / y is
/// exactly 0 for a line alone, and one half where half of its band is covered by another.
///
/// A pixel is lost, in proportion to its owner's coverage, if the owner has a higher rank and runs alongside: wholly at
/// angles up to 30 degrees, not at all from 60 on, so that crossing lines stay. Lines that meet diverge: against the
/// line in whose band the run ends, all is lost up to 10 degrees and nothing from 25 on, so that corners stay closed.
/// Runs shorter than half their band's width lose at any angle; from three times that length on they are treated like
/// others. Lines of one small figure (elision/figures.h) take nothing from each other, and it is the figure that is
/// short or not. A line that continues beyond the end of another takes over from it there, so that not both are elided
/// in between.
///
/// Cole 2009, section 5.2.2, compares the pixel count in a square window with the expected one; here the window is
/// aligned with the line and its positions read the pixels they lie in, so that the result does not depend on the
/// line's orientation in the grid.
Array<vec2> crowding(const OwnBands& own, const PriorityBuffer& buffer, const Cancel* cancel = nullptr);

}  // namespace fovea::elision
