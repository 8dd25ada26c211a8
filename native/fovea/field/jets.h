// SPDX-License-Identifier: GPL-3.0-or-later
// Curvature from jets: a polynomial height function fitted to the surroundings of each vertex.
#pragma once

#include <fovea/field/curvature.h>
#include <fovea/field/neighbors.h>

namespace fovea::field {

struct JetOptions {
    int degree = 4;  ///< of the polynomial, 2 to 4; degree 2 leaves C at what the frame alone gives
    int rings = 3;   ///< of neighbors that are fitted, 1 to 32; more rings: smoother, slower
    /// All points weigh the same: for noisy positions; else by 1 / (0.1 + squared distance / mean^2).
    bool even = false;
};

/// One per vertex. Converges on irregular meshes, too. Where there are too few points for the degree, more rings are
/// taken, then a lower degree; where no degree 2 fits (fewer than 6 points, or all on one line or conic) k and C are
/// zero and the frame is arbitrary; without any triangle all is zero. Does not look across hard edges.
/// Cazals & Pouget, "Estimating Differential Quantities Using Polynomial Fitting of Osculating Jets", CAGD 2005.
/// `normals`: those of the vertices with these neighbors.
Array<Curvature> jet_curvature(const Surface& surface, const Neighbors& neighbors, const Array<vec3>& normals,
                               const JetOptions& options);

/// Root mean square of the residuals of these fits over mean edge lengths, median over about `samples` vertices spread
/// evenly over the surface's numbering: how noisy the positions are. Zero when nothing can be fitted.
double jet_noise(const Surface& surface, const Neighbors& neighbors, const Array<vec3>& normals,
                 const JetOptions& options, Index samples = 500);

}  // namespace fovea::field
