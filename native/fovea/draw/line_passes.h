// SPDX-License-Identifier: GPL-3.0-or-later
// Passes of lines for compositing: by line set, hidden ones apart, their distances, and whose they are.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include <fovea/base/types.h>
#include <fovea/draw/options.h>

namespace fovea::draw {

class Frame;

/// Pixels as those of Picture; empty: not requested. They are drawn by the CPU, whichever backend draws the picture.
struct LinePasses {
    /// Strokes of hidden parts. Premultiplied, as the next ones.
    Array<vec4> hidden;
    /// Strokes of visible parts by the name of their line set, in the order of the style; sets of one name share one.
    /// Over one another in this order, with `hidden` below, they have the alpha of Picture::lines. They have its
    /// colors, too, except where strokes of different colors overlap: in the picture these lie in the order of objects.
    std::vector<std::pair<std::string, Array<vec4>>> line_sets;
    /// Distance along the view axis of the nearest line that has ink at the pixel; background_depth where none has.
    Array<float> depth;
    /// How that line moves (line_motion.h); 0 where no line has ink.
    Array<vec4> vector;
    /// Number in [1, 2^24) of the line that has the greatest share of the pixel's ink, from its path's id: of lines of
    /// the mesh the same in all frames, and for few lines that of another one; 0: no line.
    Array<float> id;
    /// Cryptomatte of objects: (id, share of ink, next id, its share), by ranks. Lines found in the image are nobody's.
    std::vector<Array<vec4>> mattes;
};

/// Whether options request any.
bool wants_line_passes(const Options& options);

/// The passes of a frame that its options request. Requires ink(). Independent of the number of threads.
LinePasses line_passes(const Frame& frame);

}  // namespace fovea::draw
