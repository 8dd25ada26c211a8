// SPDX-License-Identifier: GPL-3.0-or-later
// Which curves are worth drawing as a whole.
#pragma once

#include <fovea/line/curves.h>

namespace fovea {

/// The pieces of curves (pieces that share sides) that reach full strength somewhere and are at least so long. Lengths
/// are those of the pieces' points. Canny, "A Computational Approach to Edge Detection", PAMI 1986, section VI.
Curves keep_strong(const Curves& pieces, double least_length);

}  // namespace fovea
