// SPDX-License-Identifier: GPL-3.0-or-later
// Curvature of a surface whose derivatives are known.
#pragma once

#include <fovea/field/curvature.h>
#include <fovea/mesh/height_jet.h>

namespace fovea {

/// Over its own tangent plane a height function's second derivatives are -h and its third ones -C. All zero where the
/// jet is.
CurvatureD curvature_of(const HeightJetD& jet);

/// One per jet.
Array<Curvature> curvature_of(const Array<HeightJet>& jets);

}  // namespace fovea
