// SPDX-License-Identifier: GPL-3.0-or-later
// Resampling: triangles of even sides, for what is derived from curvature.
#pragma once

#include <fovea/repair/repair.h>

namespace fovea::repair {

/// Makes triangles whose sides are about as long as `edge_length` (object units; 0: as long as they are on average), in
/// so many steps: splits long edges, collapses short ones, evens out valences, relaxes vertices along the surface and
/// puts them back on the old triangles. Edges stay where they are that are borders, marked, between materials, or where
/// polygons meet at more than 40 degrees; they may be divided. Polygons that are not manifold or have a vertex without
/// a position stay as they are, and are counted in the mesh's report. Loose edges are left out.
///
/// Botsch & Kobbelt, "A Remeshing Approach to Multiresolution Modeling", SGP 2004, section 4.
void resample(RepairedMesh& mesh, int steps, double edge_length);

}  // namespace fovea::repair
