// SPDX-License-Identifier: GPL-3.0-or-later
// The center line of a run as its pen draws it, whatever makes marks of it: triangles (tessellate.h) or curves.
#pragma once

#include <fovea/path/paths.h>
#include <fovea/stroke/along.h>
#include <fovea/stroke/emphasis.h>
#include <fovea/stroke/fade.h>
#include <fovea/stroke/marks.h>
#include <fovea/stroke/vanish.h>
#include <fovea/visibility/runs.h>

namespace fovea::stroke {

/// What changes strokes from one drawing of an animation to the next (style/animation.h).
struct Moment {
    double boil = 0.0;     ///< how much of the hand is that of the boil's drawing
    int boil_drawing = 0;  ///< its number in the cycle
    double written = 1.0;  ///< share of each line, times that of its pen
    style::Vanish vanish = style::Vanish::fade;
};

/// What the strokes of a picture are made of. Borrowed.
struct Inking {
    const ClippedPaths& clipped;
    const Runs& runs;
    In<Index> pen_of_run;  ///< index into `pens` per run; `none` draws nothing
    In<float> strength;    ///< per point of Paths, in [0,1]; reduces width or opacity; empty: 1
    In<Pen> pens;
    In<float> visibility = {};     ///< per atlas sample; partly visible ends fade (fade.h). Empty: all are sharp
    Emphasis emphasis = {};        ///< mixes each pen with its out-of-focus pen; what is left of lines
    In<std::uint64_t> ids = {};    ///< per path of Paths, seed of its wobble and noise; empty: the path's number
    const Paths* paths = nullptr;  ///< to which pens fix their marks; null: all paths change with the view
    const Marks* marks = nullptr;  ///< of those that change with the view; null: by their arc length
    double tolerance_px = 0.1;     ///< of what is drawn beside the run, as `simplify` takes it
    In<PenPaint> paints = {};      ///< one per pen; empty: none takes anything of surfaces
    Moment moment = {};
};

/// Length of the marks of a pen [px].
double mark_length_px(const Pen& pen);

/// Throws std::invalid_argument where arrays do not fit together.
void check_inking(const Inking& inking);

/// A run's center line with the width, opacity and mixes of its pen. `closed`: its last point repeats the first.
struct DrawnLine {
    CenterLine points;
    bool closed = false;
};

/// Shapes one run after the other.
class LineShaper {
   public:
    /// `inking` must be checked, and outlive this.
    explicit LineShaper(const Inking& inking);

    /// Shapes a run that has a pen. False for one without length in pixels, of which nothing is drawn.
    bool shape(Index run, DrawnLine& out) const;

   private:
    const Inking& inking_;
    std::vector<Modifiers> modifiers_;
};

}  // namespace fovea::stroke
