// What lines know of a surface at each vertex: curvature, and the size of its features.
#pragma once

#include <memory>
#include <string>

#include "field/curvature.h"
#include "field/neighbours.h"

namespace fovea {

enum class Estimator { automatic, jets, one_ring };

struct FieldOptions {
    Estimator estimator = Estimator::automatic;
    int degree = 0;  ///< of jets, 2 to 4; 0: automatic
    int rings = 0;   ///< of jets, 1 to 32; 0: automatic
    double hard_angle = default_hard_angle;
};

struct Fields {
    Array<Curvature> curvature;  ///< per vertex
    /// Length against which curvatures are measured: min(0.01 / q, 0.05 R) with q the 10 % quantile, by area, of |k1|
    /// and |k2| over all vertices and R the radius of the surface; 0 for a surface without area. As in rtsc
    /// (DeCarlo et al.), but of all vertices instead of a random sample.
    float feature_size = 0.0f;
    std::string reason;          ///< one sentence: which estimator was taken, and why
};

/// Kept with the surface, by the options. Automatic takes jets, of degree 4 over 3 rings where the positions are clean
/// and of degree 3 over more rings the noisier they are. Throws std::invalid_argument for options out of range.
std::shared_ptr<const Fields> fields_of(const Surface& surface, const FieldOptions& options = {});

/// What tells options apart where something is kept by them.
std::uint64_t key_of(const FieldOptions& options);

}  // namespace fovea
