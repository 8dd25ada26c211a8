// SPDX-License-Identifier: GPL-3.0-or-later
// How lines come and go that are seen for a part of the time.
#pragma once

#include <fovea/stroke/center_line.h>
#include <fovea/stroke/noise.h>
#include <fovea/style/animation.h>

namespace fovea::stroke {

/// Takes opacity or width of a shaped line by the share of the time for which its points are seen (CenterPoint::seen).
/// What breaks up does so through the pen's texture, whose faintest ink goes first: of so much of it as is the share
/// something is left. Of a solid pen it shrinks by the share above a threshold, which is noise fixed to the path
/// (noise_along): it leaves blots, the longer the wider the pen is. What retracts is as it is: its runs are shorter.
void vanish(CenterLine& line, style::Vanish how, const Pen& pen, const Hand& hand);

}  // namespace fovea::stroke
