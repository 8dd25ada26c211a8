// SPDX-License-Identifier: GPL-3.0-or-later
// The elision test: how much of a line's own band is left to it where more important lines go along.
#pragma once

#include <fovea/elision/own_band.h>
#include <fovea/elision/priority_buffer.h>

namespace fovea::elision {

/// The window: 5 pixels along the line in so many columns, which reach over the whole band, however wide.
inline constexpr float window_length_px = 5.0f;
inline constexpr int window_columns = 3;
/// Places in each column, at most half a pixel apart, or so many.
inline constexpr int most_window_rows = 8;
/// So many times half the band's width from a run's end a line no longer meets another there.
inline constexpr float end_reach = 8.0f;

/// Per sample of a run: pixels of the line's own band in the window (y), and how many of these are lost (x); pixels
/// that the edge of the band, or an end of the run, passes through count in part. (0, 0) outside of the picture. So x /
/// y is exactly 0 for a line alone, and half where half of its band lies under another.
///
/// A pixel is lost, in part where its owner covers it in part, if a line of higher rank has it that goes along: wholly
/// at up to 30 degrees between the two, not at all from 60 on, so that lines cross. Lines that meet diverge: to the one
/// in whose band the run ends it loses wholly up to 10 degrees, nothing from 25 on, so that corners stay closed. Ticks,
/// runs shorter than half their band's width, lose at any angle; runs three times as long no more than others. A line
/// that goes on beyond the end of another takes over from it there, so that none of the two is missing in between.
///
/// Cole 2009, section 5.2.2, counts pixels of a square window against those expected; here the window lies along the
/// line, and its places ask the pixels that they are in, so that it does not matter how the line lies in the grid.
Array<vec2> crowding(const OwnBands& own, const PriorityBuffer& buffer, const Cancel* cancel = nullptr);

}  // namespace fovea::elision
