// Runs become strokes: strips of triangles with pens.
#pragma once

#include "atlas/runs.h"
#include "stroke/pen.h"
#include "stroke/strokes.h"

namespace fovea {

/// Shapes every run that has a pen into a strip. The most hidden runs come first and visible ones last, so that visible
/// strokes lie on top; those that are hidden alike keep the order of the runs. `pen_of_run`: index into `pens` per run;
/// `none` draws nothing. `strength`: per point of Paths, in [0,1], multiplies opacity; empty: 1. A run over the whole of
/// a closed piece is joined to itself; other runs end in the pen's caps, and taper where their path ends freely; those
/// that start before or end after their piece go straight on. `visibility`: partly visible samples (atlas order) at the
/// ends of runs fade them out (fade.h); empty: all ends are sharp. Runs without length in pixels and points that are not finite are left out. The same for any number of threads.
Strokes tessellate(const ClippedPaths& clipped, const Runs& runs, In<Index> pen_of_run, In<float> strength,
                   In<Pen> pens, In<float> visibility = {});

}  // namespace fovea
