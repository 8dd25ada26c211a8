// SPDX-License-Identifier: GPL-3.0-or-later
// Contours that enclose almost no area.
#pragma once

#include <fovea/path/paths.h>

namespace fovea::project {

inline constexpr std::size_t paths_per_block = 512;  ///< of parallel loops

/// Of closed contours (paths, ascending), those that touch no other contour. One that touches another may be part of
/// its outline: where its facets hide the other contour. Parallel; does not depend on the number of threads.
Array<Index> slivers_apart(const Paths& paths, In<Index> slivers);

}  // namespace fovea::project
