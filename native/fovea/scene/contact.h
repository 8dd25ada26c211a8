// SPDX-License-Identifier: GPL-3.0-or-later
// Surfaces that touch and do not pass through each other.
#pragma once

#include <fovea/scene/crossings.h>

namespace fovea::scene {

/// A surface mapped into the space of crossings.
struct Mapped {
    const Surface& surface;
    Affine map;

    dvec3 corner(Index triangle, int i) const {
        return map * dvec4(dvec3(surface.positions[surface.triangles[triangle][i]]), 1.0);
    }
};

/// Crossings without those along sides where one surface touches the other, and without curves shorter than a few
/// tolerances (a length, in the space of crossings).
Crossings without_contact(const Crossings& crossings, const Mapped& first, const Mapped& second, double tolerance);

}  // namespace fovea::scene
