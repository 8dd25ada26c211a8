// Fields of a surface on demand.
#pragma once

#include <string>

#include "field/curvature.h"
#include "mesh/surface.h"

namespace fovea {

struct FieldOptions {
    int degree = 0, rings = 0;  ///< of the jets; 0: chosen by the mesh's noise
};

/// What lines of the field are made of.
struct Fields {
    Array<Curvature> curvature;  ///< per vertex
    float feature_size = 0.0f;   ///< length that makes thresholds dimensionless: small where curvature is great
    std::string reason;          ///< why the estimator was chosen, in a sentence
};

/// Kept with the surface.
std::shared_ptr<const Fields> fields_of(const Surface& surface, const FieldOptions& options);

/// The smaller of a hundredth of the radius of curvature that nine tenths of the surface are flatter or rounder than,
/// and a twentieth of the surface's radius: min(0.01 / q, 0.05 R), q the area-weighted 10 % quantile of all |k1| and |k2|.
float feature_size(const Surface& surface, const Array<Curvature>& curvature);

}  // namespace fovea
