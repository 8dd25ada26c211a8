// SPDX-License-Identifier: GPL-3.0-or-later
// Per-object options of the estimated fields of a surface (native/field). Stored with the surface, so that all users of
// its fields get the same ones.
#pragma once

#include <string>

#include <fovea/base/check.h>

namespace fovea::mesh {

enum class Estimator { automatic, jets, one_ring };

/// Angle between facet normals, in degrees, above which an edge may count as hard.
inline constexpr double default_hard_angle = 40.0;

struct FieldOptions {
    Estimator estimator = Estimator::automatic;
    int degree = 0;  ///< degree of the jets, 2 to 4; 0: automatic
    int rings = 0;   ///< rings of neighbors that a jet is fitted to, 1 to 32; 0: automatic
    /// Standard deviation, in edge lengths, of the Gaussian that averages curvature, up to 8. 0: no averaging, or with
    /// the automatic estimator an amount chosen by the estimated noise.
    double smoothing = 0.0;
    double hard_angle = default_hard_angle;
};

/// Throws std::invalid_argument for options out of range. `name`: of the object, for the message.
inline void check_options(const FieldOptions& options, const std::string& name) {
    const bool known = options.degree == 0 || (options.degree >= 2 && options.degree <= 4);
    check(known, name + ": degree of jets must be 0, 2, 3 or 4");
    check(options.rings >= 0 && options.rings <= 32, name + ": rings of jets must be 0 to 32");
    check(options.smoothing >= 0.0 && options.smoothing <= 8.0, name + ": smoothing of curvature must be 0 to 8 edges");
}

}  // namespace fovea::mesh
