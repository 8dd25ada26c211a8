// SPDX-License-Identifier: GPL-3.0-or-later
// Crowds: very many lines in one place, as of solids that coincide. A ray to one of them meets what all of them lie on,
// so the cost of asking for each would grow with the square of their number.
#pragma once

#include <fovea/path/paths.h>
#include <fovea/project/clipped_paths.h>
#include <fovea/scene/tracer.h>

namespace fovea::visibility {

/// Pieces that are alike are a crowd if they are more than this many.
inline constexpr std::size_t crowd = 16;

/// Per piece the first one of its crowd, whose visibility it shares; itself where it is in none. Empty: there are no
/// crowds. Alike are pieces whose points are the same, to 1/64 px in the image and to less than ray_margin in distance,
/// and whose segments lie on surfaces of the same directions.
Array<Index> first_of_crowds(const ClippedPaths& clipped, const Paths& paths, const Tracer& tracer);

}  // namespace fovea::visibility
