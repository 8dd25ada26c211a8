// SPDX-License-Identifier: GPL-3.0-or-later
// Lines on paper.
#pragma once

#include <fovea/base/types.h>

namespace fovea {

/// out = lines over paper; everything scene-linear and premultiplied, one entry per pixel.
/// `film_transparent`: there is no paper. `holdout`: share of the pixel, in [0,1], where paper is
/// cut out; empty: nowhere. `out` is resized.
void compose(In<vec4> lines, vec3 paper, bool film_transparent, In<float> holdout, Array<vec4>& out);

}  // namespace fovea
