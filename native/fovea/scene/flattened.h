// SPDX-License-Identifier: GPL-3.0-or-later
// Placements whose transform flattens their surface: it has no inverse, without which no ray is cast into them.
#pragma once

#include <fovea/base/types.h>

namespace fovea::scene {

/// The transform itself or, where it flattens a surface to a plane or a line (a scale of 0 along an axis, say), one
/// near it that leaves the surface a thickness of 1/2048 of its size: less than a pixel, but what lies above hides what
/// lies below, and the outline is that of the flattened surface. The thickness is on the upper side of the plane, so
/// that a floor in that plane hides nothing of it. `center`, `half`: of the surface's bounding box. Transforms to a
/// single point, and those that are not finite, are returned as they are.
dmat4 with_thickness(const dmat4& object_to_world, const dvec3& center, const dvec3& half);

}  // namespace fovea::scene
