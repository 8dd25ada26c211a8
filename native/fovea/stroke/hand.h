// SPDX-License-Identifier: GPL-3.0-or-later
// Positional jitter and pressure along a center line.
#pragma once

#include <cstdint>

#include <fovea/stroke/center_line.h>

namespace fovea::stroke {

/// Moves a line sideways by smooth noise of its arc length: at most `amount_px`, in waves of about `length_px`. The
/// noise belongs to `seed` and stays where it is along the path, whatever is hidden of it. Ends (of a closed line: the
/// seam) stay where they are, so that corners of the drawing stay closed. Before `shape`.
void wobble(CenterLine& line, double amount_px, double length_px, std::uint64_t seed);

/// Thins a line towards its ends: `amount` in [0,1] of its width is left out there, nothing in the middle. After
/// `shape`.
void press(CenterLine& line, float amount);

}  // namespace fovea::stroke
