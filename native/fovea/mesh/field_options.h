// SPDX-License-Identifier: GPL-3.0-or-later
// What an object asks of the fields of its surface (native/field): kept with the surface, so that whoever needs fields
// gets the same.
#pragma once

#include <string>

#include <fovea/base/check.h>

namespace fovea::mesh {

enum class Estimator { automatic, jets, one_ring };

/// Degrees between facet normals above which an edge may be hard.
inline constexpr double default_hard_angle = 40.0;

struct FieldOptions {
    Estimator estimator = Estimator::automatic;
    int degree = 0;  ///< of jets, 2 to 4; 0: automatic
    int rings = 0;   ///< of jets, 1 to 32; 0: automatic
    /// Standard deviation, in edge lengths, of the Gaussian that curvature is averaged with, up to 8; 0: not at all,
    /// or, with the automatic estimator, as much as noise asks for.
    double smoothing = 0.0;
    double hard_angle = default_hard_angle;
};

/// Throws std::invalid_argument for options out of range; `name`: of the object.
inline void check_options(const FieldOptions& options, const std::string& name) {
    const bool known = options.degree == 0 || (options.degree >= 2 && options.degree <= 4);
    check(known, name + ": degree of jets must be 0, 2, 3 or 4");
    check(options.rings >= 0 && options.rings <= 32, name + ": rings of jets must be 0 to 32");
    check(options.smoothing >= 0.0 && options.smoothing <= 8.0, name + ": smoothing of curvature must be 0 to 8 edges");
}

}  // namespace fovea::mesh
