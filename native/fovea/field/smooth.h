// SPDX-License-Identifier: GPL-3.0-or-later
// Smoothing of curvature over the surface.
#pragma once

#include <fovea/field/curvature.h>
#include <fovea/field/neighbors.h>

namespace fovea::field {

/// Averages both tensors, h and C, over the neighborhood of each vertex, with weights: Gaussian of distance, times
/// vertex area, times n . n'. `deviation`: of the Gaussian, in mean edge lengths at the vertex. Tensors are
/// parallel-transported between tangent planes, so that spheres and cylinders are unchanged. Stops at hard edges:
/// vertices on one contribute only to themselves. Normals are unchanged. As trimesh2 diffuses curvature (Rusinkiewicz).
Array<Curvature> smooth(const Surface& surface, const Neighbors& neighbors, const Array<Curvature>& curvature,
                        double deviation);

}  // namespace fovea::field
