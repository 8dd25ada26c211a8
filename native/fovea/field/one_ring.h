// SPDX-License-Identifier: GPL-3.0-or-later
// Curvature from one-rings: finite differences of vertex normals along the edges of triangles.
#pragma once

#include <fovea/field/curvature.h>
#include <fovea/field/neighbors.h>

namespace fovea::field {

/// Curvature per vertex. Fast, and accurate on regular meshes; on irregular ones k does not converge and C diverges:
/// use jets there. Triangles across a hard edge from one of their vertices (see neighbors.h) use their own normal at it
/// and contribute no C. All zero where a vertex has no triangle with positive area. Rusinkiewicz, "Estimating
/// Curvatures and Their Derivatives on Triangle Meshes", 3DPVT 2004.
Array<Curvature> one_ring_curvature(const Surface& surface, const Neighbors& neighbors);

}  // namespace fovea::field
