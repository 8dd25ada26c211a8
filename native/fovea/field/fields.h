// SPDX-License-Identifier: GPL-3.0-or-later
// What lines know of a surface at each vertex: curvature, and the size of its features.
#pragma once

#include <memory>
#include <string>

#include <fovea/field/curvature.h>
#include <fovea/field/neighbors.h>

namespace fovea::field {

struct Fields {
    Array<Curvature> curvature;  ///< per vertex
    /// Length against which curvatures are measured: min(0.01 / q, 0.05 R) with q the 10 % quantile, by area, of |k1|
    /// and |k2| over all vertices and R the radius of the surface; 0 for a surface without area. As in rtsc
    /// (DeCarlo et al.), but of all vertices instead of a random sample.
    float feature_size = 0.0f;
    std::string reason;  ///< one sentence: which estimator was taken, and why
};

/// With the surface's own options, and with others. Kept with the surface, by the options. Automatic takes the jets
/// that come with a surface; without, it fits some: of degree 4 over 3 rings where the positions are clean, else of
/// degree 3 over the more rings the less the surface bends within them, and smoothed where the positions are noisy.
/// Throws std::invalid_argument for options out of range. A stretched surface has the fields of its source, mapped in
/// closed form, and the source's hard edges.
std::shared_ptr<const Fields> fields_of(const Surface& surface);
std::shared_ptr<const Fields> fields_of(const Surface& surface, const FieldOptions& options);

/// The reason of the fields that the surface's own options gave; empty where nobody has asked for them yet (and while
/// something else is being computed).
std::string fields_reason(const Surface& surface);

/// Hash of all options.
std::uint64_t hash_of(const FieldOptions& options);

}  // namespace fovea::field
