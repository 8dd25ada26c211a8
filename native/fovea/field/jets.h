// SPDX-License-Identifier: GPL-3.0-or-later
// Curvature from osculating jets: a polynomial height function fitted to the neighborhood of each vertex.
#pragma once

#include <fovea/field/curvature.h>
#include <fovea/field/neighbors.h>

namespace fovea::field {

struct JetOptions {
    int degree = 4;  ///< of the polynomial, 2 to 4; with degree 2 its third derivatives are zero
    int rings = 3;   ///< rings of neighbors to fit, 1 to 32; more: smoother, slower
    /// Weight all points equally, for noisy positions; else by 1 / (0.1 + squared distance / mean^2).
    bool even = false;
};

/// Curvature per vertex; converges on irregular meshes, too. If there are too few points for the degree, more rings are
/// added, then the degree is lowered; if not even degree 2 is determined (fewer than 6 points, or all on one line or
/// conic), k and C are zero and the frame is arbitrary. All zero for a vertex without triangles. Neighborhoods stop at
/// hard edges. Cazals & Pouget, "Estimating Differential Quantities Using Polynomial Fitting of Osculating Jets", CAGD
/// 2005.
Array<Curvature> jet_curvature(const Surface& surface, const Neighbors& neighbors, const JetOptions& options);

/// The same of these vertices alone.
Array<Curvature> jet_curvature(const Surface& surface, const Neighbors& neighbors, const JetOptions& options,
                               In<Index> vertices);

/// Estimated noise of positions: RMS residual of these fits in units of the mean edge length, as the median over about
/// `samples` vertices at equal index steps. Zero if nothing can be fitted.
double jet_noise(const Surface& surface, const Neighbors& neighbors, const JetOptions& options, Index samples = 500);

}  // namespace fovea::field
