// SPDX-License-Identifier: GPL-3.0-or-later
// Fields of a surface that line definitions read: curvature per vertex, and feature size.
#pragma once

#include <memory>
#include <string>

#include <fovea/field/curvature.h>
#include <fovea/field/neighbors.h>

namespace fovea::field {

struct Fields {
    Array<Curvature> curvature;  ///< per vertex
    /// Length that normalizes curvature thresholds: min(0.01 / q, 0.05 R), with q the 10 % quantile, weighted by area,
    /// of |k1| and |k2| over all vertices and R the surface's bounding radius; 0 for a surface without area. As in rtsc
    /// (DeCarlo et al.), but over all vertices instead of a random sample.
    float feature_size = 0.0f;
    std::string reason;  ///< one sentence: which estimator was chosen, and why
};

/// Fields with the surface's own options, and with others. Cached with the surface, per options. The automatic
/// estimator uses the surface's exact jets if it has any; otherwise it fits jets: of degree 4 over 3 rings if the
/// positions are clean, else of degree 3 over more rings the less the surface bends within them, smoothed if the
/// positions are noisy. Throws std::invalid_argument for options out of range. A stretched surface has the fields of
/// its source, mapped in closed form, and its source's hard edges.
std::shared_ptr<const Fields> fields_of(const Surface& surface);
std::shared_ptr<const Fields> fields_of(const Surface& surface, const FieldOptions& options);

/// Upper bound of their feature size, without fitting anything.
float greatest_feature_size(const Surface& surface);

/// Normals, per one of `vertices`, of the surface that the fields with the surface's own options are fitted to, which
/// smoothing leaves as they are. These vertices alone are fitted.
Array<vec3> fitted_normals(const Surface& surface, In<Index> vertices);

/// The `reason` of the fields with the surface's own options; empty if they are not cached yet or the cache is locked
/// by another computation.
std::string fields_reason(const Surface& surface);

/// Hash of all members.
std::uint64_t hash_of(const FieldOptions& options);

}  // namespace fovea::field
