// SPDX-License-Identifier: GPL-3.0-or-later
// Curvature of surfaces with known derivatives: implicit (F = 0), or heights over the tangent plane.
#pragma once

#include <fovea/field/curvature.h>
#include <fovea/mesh/height_jet.h>

namespace fovea::field {

/// Derivatives of F at a point; F increases outwards.
struct ImplicitJet {
    dvec3 gradient{0.0};
    dmat3 hessian{0.0};
    /// Third derivatives: third[i] is d H / d x_i.
    dmat3 third[3] = {dmat3(0.0), dmat3(0.0), dmat3(0.0)};
};

/// Exact for the jet with gradient g, Hessian H and third derivatives T; on tangents x, y, z
///   h(x, y) = H(x, y) / |g|
///   C(x, y, z) = (T(x, y, z) - h(x, z) H(n, y) - h(y, z) H(n, x) - h(x, y) H(n, z)) / |g|.
/// All zero if the gradient is. Goldman, "Curvature formulas for implicit curves and surfaces", CAGD 2005.
CurvatureD curvature_of(const ImplicitJet& jet);

/// Curvature of a surface's image under a linear map, at the image of a point with curvature `c`. `inverse`: inverse of
/// the map. Exact: computed from the mapped osculating jet. The outside stays outside.
CurvatureD mapped(const Curvature& c, const dmat3& inverse);

/// Curvature from a height function: over its tangent plane h = -f'' and C = -f'''. All zero if the jet is.
CurvatureD curvature_of(const HeightJetD& jet);

/// Per jet.
Array<Curvature> curvature_of(const Array<HeightJet>& jets);

}  // namespace fovea::field
