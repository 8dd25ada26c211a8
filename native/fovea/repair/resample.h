// SPDX-License-Identifier: GPL-3.0-or-later
// Isotropic remeshing, for quantities derived from curvature.
#pragma once

#include <fovea/repair/repair.h>

namespace fovea::repair {

/// Remeshes to triangles with sides of about `edge_length` (object units; 0: the mean length), in `steps` iterations
/// of: split long edges, collapse short ones, equalize valences by flips, relax vertices tangentially and project them
/// onto the original triangles. Feature edges stay in place but may be divided: borders, marked edges, edges between
/// materials, and edges whose face normals differ by more than 40 degrees. Non-manifold polygons and those with a
/// non-finite vertex are unchanged and counted in the mesh's report. Loose edges are dropped. A mesh of which there
/// would be more than about `most` triangles stays as it is, and its report says how many.
///
/// Botsch & Kobbelt, "A Remeshing Approach to Multiresolution Modeling", SGP 2004, section 4.
void resample(RepairedMesh& mesh, int steps, double edge_length, std::uint64_t most);

}  // namespace fovea::repair
