// SPDX-License-Identifier: GPL-3.0-or-later
// Curvature of a surface whose derivatives are known: given as F = 0, or as heights over its tangent plane.
#pragma once

#include <fovea/field/curvature.h>
#include <fovea/mesh/height_jet.h>

namespace fovea::field {

/// F's derivatives at a point, F growing outwards.
struct ImplicitJet {
    dvec3 gradient{0.0};
    dmat3 hessian{0.0};
    /// Third derivatives: third[i] is d H / d x_i.
    dmat3 third[3] = {dmat3(0.0), dmat3(0.0), dmat3(0.0)};
};

/// Exact for the jet: h(x, y) = H(x, y) / |g| and C = (T - h H(n, .) summed over its three places) / |g| on tangents.
/// All zero where the gradient is. Goldman, "Curvature formulas for implicit curves and surfaces", CAGD 2005.
CurvatureD curvature_of(const ImplicitJet& jet);

/// Of the image of a surface under a linear map, at the image of a point where the surface has the curvature `c`;
/// `inverse`: that of the map. Exact: it is the image of the point's osculating jet. What was outside stays outside.
CurvatureD mapped(const Curvature& c, const dmat3& inverse);

/// Over its own tangent plane a height function's second derivatives are -h and its third ones -C. All zero where the
/// jet is.
CurvatureD curvature_of(const HeightJetD& jet);

/// One per jet.
Array<Curvature> curvature_of(const Array<HeightJet>& jets);

}  // namespace fovea::field
