// SPDX-License-Identifier: GPL-3.0-or-later
// Removal of contact: places where surfaces touch without crossing.
#pragma once

#include <fovea/scene/crossings.h>

namespace fovea::scene {

/// A surface with a map into the space of its crossings.
struct Mapped {
    const Surface& surface;
    Affine map;

    dvec3 corner(Index triangle, int i) const {
        return map * dvec4(dvec3(surface.positions[surface.triangles[triangle][i]]), 1.0);
    }
};

/// Removes crossings along sides at which one surface merely touches the other, and curves that are not longer than 16
/// tolerances. `tolerance`: a length in the space of the crossings.
Crossings without_contact(const Crossings& crossings, const Mapped& first, const Mapped& second, double tolerance);

}  // namespace fovea::scene
