// SPDX-License-Identifier: GPL-3.0-or-later
// What is left of a pen's texture where there are no pixels: dashes, or how wide and how dense its ink is.
#pragma once

#include <fovea/stroke/pen.h>

namespace fovea::vector {

struct Grain {
    double width = 1.0;    ///< of the pen's, where there is about as much ink as in the middle
    double opacity = 1.0;  ///< mean of the ink there
    /// Lengths of dashes and gaps in turn, in repetitions of the texture; empty: none.
    std::vector<double> dashes;
    double first = 0.0;     ///< where the first of them begins, in repetitions
    bool round = false;     ///< dashes end in half discs as wide as the pen, which count in their length
    PenTexture dividing{};  ///< the texture with octaves, of dashes that a pen fixes to paths; else empty
};

/// Of a texture; null: solid. `anchored`: a pen fixes it to paths.
Grain grain_of(const PenTexture* texture, bool anchored = false);

}  // namespace fovea::vector
