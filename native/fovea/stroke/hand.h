// SPDX-License-Identifier: GPL-3.0-or-later
// Positional jitter and pressure along a center line.
#pragma once

#include <fovea/stroke/center_line.h>
#include <fovea/stroke/noise.h>

namespace fovea::stroke {

/// Displaces a line sideways by smooth noise of its arc length: at most `amount_px`, with wavelengths of about
/// `length_px`. The noise is that of `hand` and is fixed to the path (noise_along), whichever parts of it are hidden.
/// Ends (of a closed line: the seam) do not move, so that corners of the drawing stay closed. Before `shape`.
void wobble(CenterLine& line, double amount_px, double length_px, const Hand& hand);

/// Pressure: reduces the width by the fraction `amount` in [0,1] at the ends of a line, by nothing in the middle. After
/// `shape`.
void press(CenterLine& line, float amount);

}  // namespace fovea::stroke
