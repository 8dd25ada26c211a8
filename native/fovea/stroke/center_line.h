// SPDX-License-Identifier: GPL-3.0-or-later
// The center line of a stroke: the visible part of a path, relieved of steps too small to see, with
// width and ends.
#pragma once

#include <fovea/project/clipped_paths.h>
#include <fovea/stroke/pen.h>

namespace fovea::stroke {

struct CenterPoint {
    dvec2 px;
    /// Arc length over the whole path [px].
    double arc;
    /// Half the drawn width [px]; set by `shape`.
    float half_width = 0.0f;
    /// Strength, until `shape` has made it what strength and thin pens leave of the pen's opacity.
    float opacity = 1.0f;
    /// How far color, texture, width and opacity are on the way to the pen out of focus, each in [0,1].
    vec4 mix{0.0f};
    /// What elision leaves of the opacity.
    float shown = 1.0f;
};

using CenterLine = std::vector<CenterPoint>;

/// The part of a piece between two arc lengths; its ends are interpolated. `strength` per point of
/// Paths, held to [0, 1], 0 where it is no number; empty: 1.
void cut(const ClippedPaths& clipped, In<float> strength, Index piece, double start_px, double end_px, CenterLine& out);

/// Goes straight on beyond either end of a line, for so many pixels (0 or less: not at all).
void lengthen(CenterLine& line, double before_px, double after_px);

/// Evens out zigzag of steps below 1.5 px (points move at most .15 px), then drops points that lie
/// within .1 px of the line between those kept, or on top of each other. Ends stay. Fewer than two
/// points are left of a line without length.
void simplify(CenterLine& line);

/// Adds points at the given arc lengths (ascending), except so near to others.
void insert_points(CenterLine& line, In<double> arcs, double near_px = 0.5);

/// Which ends of a line taper.
struct TaperedEnds {
    bool start, end;
};

/// The pens in and out of focus; the caps, tapers and hand of the first hold for both.
struct PenPair {
    const Pen &in_focus, &out_of_focus;
};

/// Sets width and opacity between those of the two pens: the width times 1 + (strength - 1) strength_width, the opacity
/// times 1 + (strength - 1) (1 - strength_width) and what is shown. The width thins to a fifth over the pen's taper at
/// ends that taper. A line too short for that thins in proportion less. Points are added where the width bends. Less
/// than a pixel is drawn as a pixel of that much less opacity.
void shape(CenterLine& line, const PenPair& pens, TaperedEnds tapered);

/// Adds a point beyond either end, as far as the cap reaches.
void extend(CenterLine& line, Cap cap);

}  // namespace fovea::stroke
