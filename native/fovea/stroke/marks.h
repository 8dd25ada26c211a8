// SPDX-License-Identifier: GPL-3.0-or-later
// Where marks are on lines of the view, handed on from frame to frame: textures, dashes, wobble.
#pragma once

#include <memory>
#include <utility>

#include <fovea/stroke/marked_lines.h>

namespace fovea::stroke {

/// Places of marks along lines of the view, in one frame.
struct Marks {
    std::shared_ptr<const MarkedLines> of;  ///< null: there are none
    /// Per place of its lines, in pixels along the line: where marks with a period are; and where those of the last key
    /// and of the next one are, between which others are mixed. `next` is empty where `share` is 0.
    Array<double> at, last, next;
    double share = 0.0;  ///< of the next key, in [0, 1)
};

/// A neighboring frame: its offset in frames (negative: earlier), and its lines. Of a moment near a frame this is at 0.
using MarkedNear = std::pair<int, std::shared_ptr<const MarkedLines>>;

/// Marks of a frame that is `since_key` frames after a key, of keys that are `frames` apart. In a key marks are where
/// the frame alone has them (MarkedLines::own). From it they are handed on to the frames after it, and to those before
/// it: a place has the mark of the line of the same object and definition that is nearest in the image to where its
/// point of the surface was in the other frame, so that marks move as the surface does (Kalnins et al. 2003, section 4,
/// hand them on forwards). Between two keys, marks of the first one move steadily to the nearest ones of the second: by
/// at most half a period. Lines that come between them have their own. Frames must reach from one key to the next
/// without a gap: beyond one, as at a cut, marks are not handed on, and with none to the next key they stay those of
/// the last one. `baked`: of the places with marks of the frame itself (MarkedLines::packed); not empty: the marks are
/// these, as they are.
Marks marks_in_time(std::shared_ptr<const MarkedLines> now, In<MarkedNear> near, int since_key, int frames,
                    In<double> baked = {});

/// Marks of the places of a frame, handed on from those of one beside it, as shares of their period; on lines that are
/// not there, those of its own.
Array<double> handed_on(const MarkedLines& now, const MarkedLines& there, In<double> marks);

}  // namespace fovea::stroke
