// SPDX-License-Identifier: GPL-3.0-or-later
// Tessellates runs into strokes: triangle strips with pens.
#pragma once

#include <fovea/stroke/drawn_line.h>
#include <fovea/stroke/strokes.h>

namespace fovea::stroke {

/// Makes a strip of every run that has a pen, in descending order of quantitative invisibility, so that visible strokes
/// lie on top; ties keep the order of the runs. Runs without length in pixels and non-finite points are skipped.
/// Independent of the number of threads.
/// - A run over the whole of a closed piece is closed; other runs end in the pen's caps, and taper at free ends of
///   their path; runs that start before their piece or end after it are extended straight.
Strokes tessellate(const Inking& inking);
Strokes tessellate(const ClippedPaths& clipped, const Runs& runs, In<Index> pen_of_run, In<float> strength,
                   In<Pen> pens, In<float> visibility = {}, const Emphasis& emphasis = {}, In<std::uint64_t> ids = {});

}  // namespace fovea::stroke
