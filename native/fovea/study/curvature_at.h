// SPDX-License-Identifier: GPL-3.0-or-later
// Curvature between vertices: forms are mixed, not principal curvatures, whose directions have no sign and turn.
#pragma once

#include <fovea/field/curvature.h>

namespace fovea::study {

/// The curvature between three vertices, by their weights, which sum to 1. All zero where a vertex has none, or their
/// normals cancel.
field::CurvatureD mixed(const field::Curvature& a, const field::Curvature& b, const field::Curvature& c,
                        const base::vec3& weights);

/// That of the same surface with its other side as the outside.
field::CurvatureD turned_around(const field::CurvatureD& of);

}  // namespace fovea::study
