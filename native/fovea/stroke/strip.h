// SPDX-License-Identifier: GPL-3.0-or-later
// Tessellates a center line with width into a triangle strip with mitred or round joins.
#pragma once

#include <fovea/stroke/center_line.h>
#include <fovea/stroke/strokes.h>

namespace fovea::stroke {

/// Bends up to 100 degrees are mitred: the cosine of the sharpest, and how long its mitre is in widths of the line.
inline constexpr double mitre_limit = -0.17, mitre_length = 1.556;

/// Values constant over a stroke.
struct StripEnds {
    /// u of the run's start and end; caps lie beyond them.
    float start, end;
    Index pen;
    /// Whether the strip's vertices have colors.
    bool colored;
};

/// Appends the strip around `line` (at least two points, neighbors not coincident), half a pixel wider than its width.
/// Bends up to `mitre_limit` are mitred, sharper ones rounded. Where the inner side of bends is longer than the steps
/// between them, their inner corners merge: no spikes, no folded triangles, and no pixel drawn twice unless the line
/// turns back on itself (more than 150 degrees) within its own width. `closed`: the last point repeats the first, and
/// is joined to it.
void add_strip(In<CenterPoint> line, bool closed, const StripEnds& ends, Strokes& out);

}  // namespace fovea::stroke
