// SPDX-License-Identifier: GPL-3.0-or-later
// The center line of a stroke: a run's part of its path, simplified, with width and ends.
#pragma once

#include <algorithm>

#include <fovea/project/clipped_paths.h>
#include <fovea/stroke/pen.h>

namespace fovea::stroke {

struct CenterPoint {
    dvec2 px;
    /// Arc length over the whole path [px].
    double arc;
    /// Half the drawn width [px]; set by `shape`.
    float half_width = 0.0f;
    /// Before `shape`: strength. After it: opacity, from that of the pen, strength and pens thinner than a pixel.
    float opacity = 1.0f;
    /// Mix of color, texture, width and opacity towards the out-of-focus pen, each in [0,1].
    vec4 mix{0.0f};
    /// Elision opacity.
    float shown = 1.0f;
    /// Share of the time for which it is seen (vanish.h).
    float seen = 1.0f;
    /// Up to how much ink of its texture nothing is left, beyond 1 by a softness; 0: all is (vanish.h).
    float faint = 0.0f;
    /// Mix towards the pen's second color, in [0,1] (along.h).
    float tint = 0.0f;
    /// Width of the pen as a fraction of the drawn width; below 1 where the pen is thinner than a pixel.
    float thinness = 1.0f;
    /// Color without the second one, scene-linear; set last (along.h).
    dvec3 color{0.0};
    /// Place on the whole path, from -.5 to .5, and how many pixels a path would have that is as large all along as it
    /// is here: for marks fixed to the path (anchor.h). 0: no marks are.
    double along = 0.0, whole_px = 0.0;
    double way = 1.0;  ///< 1 where `along` ascends along the line, -1 where it descends
    /// Places of noise, which has no period, and of the other one with which it is mixed, with the share of this.
    double noise_along = 0.0, next_along = 0.0, next = 0.0;

    /// Opacity of its ink within the width of the pen, whose texture has its mean everywhere.
    float mean_opacity() const { return opacity * (faint > 0.0f ? seen : 1.0f) / std::max(thinness, 1e-6f); }

    /// Moves its places along the line, which goes on as here.
    void go(double px) {
        arc += px;
        if (!(whole_px > 0.0)) return;
        for (double* const place : {&along, &noise_along, &next_along}) *place += way * px / whole_px;
    }
};

using CenterLine = std::vector<CenterPoint>;

/// The part of a piece between two arc lengths; its ends are interpolated. `strength` per point of Paths, clamped to
/// [0, 1], NaN: 0; empty: 1.
void cut(const ClippedPaths& clipped, In<float> strength, Index piece, double start_px, double end_px, CenterLine& out);

/// Extends a line straight beyond its ends by these lengths (0 or less: not at all).
void lengthen(CenterLine& line, double before_px, double after_px);

/// Leaves what lies before an arc length; fewer than two points where nothing does.
void cut_off(CenterLine& line, double arc);

/// Smooths zigzags with steps below 1.5 px (points move by at most .15 px), then drops points within `tolerance_px` of
/// the segment between the remaining ones, and coincident points. Ends stay. A line without length becomes fewer than
/// two points.
void simplify(CenterLine& line, double tolerance_px = 0.1);

/// Inserts points at the given arc lengths (ascending), except within `near_px` of existing ones.
void insert_points(CenterLine& line, In<double> arcs, double near_px = 0.5);

/// Arc lengths inside a line at integer multiples of `step`, independent of where the line begins.
std::vector<double> multiples(const CenterLine& line, double step);

/// Which ends of a line taper.
struct TaperedEnds {
    bool start, end;
};

/// The pens in and out of focus; caps, tapers and jitter are those of the first.
struct PenPair {
    const Pen &in_focus, &out_of_focus;
};

/// Sets width and opacity, interpolated between the two pens: width times 1 + (strength - 1) strength_width, opacity
/// times 1 + (strength - 1) (1 - strength_width) and `shown`. Over the pen's taper, the width falls to a fifth at
/// tapered ends; on a line too short for that it falls proportionally less. Inserts points where the width is not
/// linear. Widths below one pixel become one pixel with opacity scaled down by the same factor.
void shape(CenterLine& line, const PenPair& pens, TaperedEnds tapered);

/// Multiplies the width of a point of a shaped line by `factor` in [0,1]; below a pixel its opacity.
void thin(CenterPoint& point, float factor);

/// Adds a point beyond each end, at the extent of the cap.
void extend(CenterLine& line, Cap cap);

}  // namespace fovea::stroke
