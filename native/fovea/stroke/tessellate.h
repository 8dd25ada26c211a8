// SPDX-License-Identifier: GPL-3.0-or-later
// Runs become strokes: strips of triangles with pens.
#pragma once

#include <fovea/stroke/emphasis.h>
#include <fovea/stroke/strokes.h>
#include <fovea/visibility/runs.h>

namespace fovea::stroke {

/// Shapes every run that has a pen into a strip. The most hidden runs come first and visible ones last, so that visible
/// strokes lie on top; those that are hidden alike keep the order of the runs. Runs without length in pixels and points
/// that are not finite are left out. The same for any number of threads.
/// - A run over the whole of a closed piece is joined to itself; other runs end in the pen's caps, and taper where
///   their path ends freely; those that start before their piece or end after it go straight on.
/// - `pen_of_run`: index into `pens` per run; `none` draws nothing.
/// - `strength`: per point of Paths, in [0,1], thins or fades (center_line.h); empty: 1.
/// - `emphasis`: leads from each pen to the one out of focus, and fades what elision drops.
/// - `ids`: per path of Paths, what wobble is made from; empty: the path's number.
/// - `visibility`: per atlas sample; those at the ends of runs that are seen in part fade them out (fade.h). Empty: all
///   ends are sharp.
Strokes tessellate(const ClippedPaths& clipped, const Runs& runs, In<Index> pen_of_run, In<float> strength,
                   In<Pen> pens, In<float> visibility = {}, const Emphasis& emphasis = {}, In<std::uint64_t> ids = {});

}  // namespace fovea::stroke
