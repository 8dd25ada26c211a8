// SPDX-License-Identifier: GPL-3.0-or-later
// Curvature from one-rings: differences of vertex normals along the edges of triangles.
#pragma once

#include <fovea/field/curvature.h>
#include <fovea/field/neighbors.h>

namespace fovea::field {

/// One per vertex. Fast and accurate on regular meshes; on irregular ones k does not converge and C diverges: use jets.
/// Triangles that lie beyond a hard edge of one of their vertices (see neighbors.h) take their own normal there and
/// give no C. All zero where a vertex has no triangle with an area.
/// Rusinkiewicz, "Estimating Curvatures and Their Derivatives on Triangle Meshes", 3DPVT 2004.
Array<Curvature> one_ring_curvature(const Surface& surface, const Neighbors& neighbors);

}  // namespace fovea::field
